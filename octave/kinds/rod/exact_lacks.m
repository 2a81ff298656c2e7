## -*- texinfo -*-
## @deftypefn {} {@var{what} =} exact_lacks (@var{scene}, @var{forms})
## What the geometrically exact rod (see @code{exact_scene} and @code{exact_body}), whose equations have the @var{forms}
## (a cellstr), lacks of a checked scene of one rod, in words; empty where it lacks nothing.
## @end deftypefn

function what = exact_lacks (scene, forms)
  what = "";
  if (! isempty (scene.initial.from))
    what = "another run's end, or an equilibrium, as its start";
  elseif (strcmp (scene.model.moment_work, "chord"))
    what = "work of the moment on the chord's rotation";
  elseif (! any (strcmp (scene.solver.name, {"auto", integrator_table(forms).name})))
    what = sprintf ("the solver %s", scene.solver.name);
  endif
endfunction

%!test # what it has not
%! [plane, lacks] = exact_scene (check_scene (setfield (swing (), "initial", "from", "equilibrium")));
%! assert (plane, []); assert (! isempty (strfind (lacks, "equilibrium")));
%! lacks = nthargout (2, @exact_scene, check_scene (setfield (swing (), "solver", "name", "waveform")));
%! assert (lacks, "the solver waveform");
