## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} given_choice (@var{rung}, @var{note})
## What @code{choose} would return for a model that the scene states: the same struct of its @var{rung}, with nothing
## tried and no error; the reason ends with the @var{note}, a sentence or empty.
## @end deftypefn

function choice = given_choice (rung, note)
  reason = "given by the scene";
  if (! isempty (note))
    reason = [reason "; " note];
  endif
  choice = struct ("trial", [], "reference", [], "rung", {rung}, "error_m", [], "reason", reason, "warnings", {{}}, ...
                   "useless", false, "tried", []);
endfunction

%!assert (given_choice ({1, 2}, "").rung, {1, 2})
%!assert (given_choice (3, "").reason, "given by the scene")
%!assert (given_choice (3, "as it is").reason, "given by the scene; as it is")
