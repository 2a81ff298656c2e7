## -*- texinfo -*-
## @deftypefn {} {[@var{rung}, @var{choice}] =} known_rung (@var{kind}, @var{scene})
## The rung of a checked scene of a @var{kind} (see @code{kind_of}) that needs no choice, with its @var{choice} (see
## @code{given_choice}): that which the scene states, or else that of the run from whose end it goes on (see
## @code{end_before}).  Others have none: @var{rung} is empty.
## @end deftypefn

function [rung, choice] = known_rung (kind, scene)
  [rung, note] = kind.stated (scene);
  choice = given_choice (rung, note);
  if (isempty (rung))
    before = end_before (kind, scene);
    if (! isempty (before))
      rung = before.rung;
      choice = setfield (given_choice (rung, ""), "reason", ["that of the run from which it goes on, " before.folder]);
    endif
  endif
endfunction

%!test # what is stated comes first
%! kind = struct ("name", "rod", "stated", @(scene) deal (scene.modes, "as it is"), "models", @(scene) 1, ...
%!                "describe", @(scene, run) struct ("model", ""));
%! [folder, gone] = scratch_folder ();
%! run = struct ("rung", 5, "model", 1, "end_state", 1, "history", struct ("t", 1), "x", 1, "y", 1);
%! write_end (kind, struct (), run, folder);
%! rung = @(modes, from) nthargout (1:2, @known_rung, kind, struct ("modes", modes, "initial", struct ("from", from)));
%! of_modes = rung (3, folder);
%! assert (of_modes{1}, 3); assert (of_modes{2}.reason, "given by the scene; as it is");
%! of_run = rung ([], folder);
%! assert ({of_run{1}, of_run{2}.rung}, {5, 5}); assert (of_run{2}.trial, []);
%! assert (of_run{2}.reason, ["that of the run from which it goes on, " folder]);
%! assert (rung ([], ""){1}, []);
