## -*- texinfo -*-
## @deftypefn {} {[@var{settings}, @var{options}] =} take_settings (@var{options})
## The @var{settings} of a sweep (a struct, see @code{sweep_settings}) among its @var{options}, a cell array of names
## and values, and the others, which are those of @code{driver}.
## @end deftypefn

function [settings, options] = take_settings (options)
  if (mod (numel (options), 2) != 0)
    scene_error ("sweep: options come as names and values, in pairs");
  endif
  fields = sweep_settings ();
  [options, own] = without_options (options, fields(:,1));
  given = struct ();
  for pair = own
    given.(pair{1}) = pair{2};
  endfor
  settings = take_fields (given, fields, "a sweep");
  for name = {"random", "jobs", "seed"}
    if (settings.(name{1}) != fix (settings.(name{1})))
      scene_error ("%s is %g: it takes a whole number", name{1}, settings.(name{1}));
    endif
  endfor
endfunction

%!test
%! [settings, options] = take_settings ({"modes", [0 1], "vary", "a=1", "jobs", 3, "solver", "rk4"});
%! assert ({settings.vary, settings.jobs, settings.engine, settings.keep}, {"a=1", 3, "auto", false});
%! assert (options, {"modes", [0 1], "solver", "rk4"});
%!error <engine is "fast": it takes "auto", "parallel", "make" or "slurm"> take_settings ({"engine", "fast"});
%!error <random is 2.5: it takes a whole number> take_settings ({"random", 2.5});
%!error <random is -2: it takes positive number of points> take_settings ({"random", -2});
%!error <sweep: options come as names and values, in pairs> take_settings ({"vary"});
