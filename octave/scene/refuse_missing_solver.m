## -*- texinfo -*-
## @deftypefn {} {} refuse_missing_solver (@var{method}, @var{instead})
## An error where this Octave lacks a scene's solver (see @code{lacks_sundials}): which method to take @var{instead}.
## @end deftypefn

function refuse_missing_solver (method, instead)
  if (lacks_sundials (method))
    scene_error ("solver.name is \"%s\": this Octave was built without SUNDIALS, take \"%s\"", method, instead);
  endif
endfunction

%!error <solver.name is "ode15s": this Octave was built without SUNDIALS, take "lsode_bdf">
%! with_stand_ins ({"yes = __have_feature__", "name", "yes = false;"}, ...
%!                 @() refuse_missing_solver ("ode15s", "lsode_bdf"));
%!test # every kind of scene refuses it before it works, where it is missing, and takes it where it is there
%! scenes = {setfield(paper (), "solver", "name", "ode15s"), setfield(double_pendulum (), "solver", "name", "ode15i"), ...
%!           setfield(bowl (), "solver", "name", "ode15s")};
%! checks = {@check_scene, @check_mechanism, @check_surface_scene};
%! for k = 1:3
%!   message = "";
%!   try
%!     checks{k} (scenes{k});
%!   catch err
%!     message = err.message;
%!   end_try_catch
%!   assert (isempty (message), logical (__have_feature__ ("SUNDIALS")));
%!   assert (isempty (message) || ! isempty (strfind (message, "without SUNDIALS")));
%! endfor
