## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{kind}, @var{output}, @var{left}] =} study_scene (@var{which}, @var{options}, @
##   @var{change})
## The checked scene of a study, its kind (see @code{kind_of}), where its files go, and a function that says how many
## seconds of the study are @var{left}: @var{which} and @var{options} (a cell array) are arguments as for
## @code{driver}, and the option "budget", the seconds that the study may take (default 60); @var{change} (scene) is
## what the study makes of the scene before it is checked.  A folder that cannot be written is an error; none, "", is
## for a study that leaves nothing.
## @end deftypefn

function [scene, kind, output, left] = study_scene (which, options, change = @(scene) scene)
  start = tic ();
  [budget, options] = taken_option (options, "budget", 60, @(s) isscalar (s) && isreal (s) && s > 0, ...
                                    "seconds, a positive number");
  left = @() max (budget - toc (start), 0);
  [scene, kind, output] = checked_scene (which, options, change);
  if (! isempty (output.folder))
    require_folder (output.folder);
  endif
endfunction

%!error <cannot be made|can be written> study_scene ("paper", {"output", "/proc/nowhere"})
%!error <model.modes is "many": it takes> study_scene ("bowl", {"modes", "many"})
%!error <budget is -1: it takes seconds, a positive number> study_scene ("paper", {"budget", -1})
%!error <budget is soon: it takes seconds> study_scene ("paper", {"budget", "soon"})
%!test
%! [scene, kind, output, left] = study_scene (swing (), {"output", tempdir(), "modes", [0 1]});
%! assert (scene.model.modes, [0 1]); assert (kind.name, "rod"); assert (output.folder, tempdir ());
%! assert (left () > 50 && left () <= 60);
%! [~, ~, ~, left] = study_scene (swing (), {"budget", 300, "output", tempdir()});
%! assert (left () > 290 && left () <= 300);
%! [~, ~, ~, left] = study_scene (swing (), {"budget", 1e-6, "output", tempdir()});
%! assert (left (), 0);
