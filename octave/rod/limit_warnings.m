## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} limit_warnings (@var{limits}, @var{of}, @var{instead})
## What is to be said where a run reaches more than its model holds for: of each slope and each strain of the
## @var{limits} (see @code{rod_limits}) that is above its limit, a warning with the number and what to do about it, a
## cellstr.  @var{of} names the rod, "" where there is one; @var{instead} is what to take where it bends too far.
## @end deftypefn

function warnings = limit_warnings (limits, of, instead)
  warnings = {};
  for limit = limits([limits.reached] > [limits.limit])
    said = "";
    if (strncmp (limit.what, "slope", 5))
      said = sprintf ("%.2g, the theory holds for small ones, here up to %g: errors of its square are %.1g; %s", ...
                      limit.reached, limit.limit, limit.reached^2/2, instead);
    elseif (! isempty (strfind (limit.what, "strain")))
      said = sprintf ("%.2g, linear elasticity holds for small ones: take smaller loads or a larger EA", limit.reached);
    endif
    if (! isempty (said))
      warnings{end+1} = sprintf ("%sthe %s reaches %s", of, limit.what, said);
    endif
  endfor
endfunction

%!test # of a slope and a strain, not of rates of rotation, which have words of their own
%! limits = struct ("what", {"slope v2,1", "axial strain", "rate"}, "limit", {0.2, 0.01, 1}, "reached", {0.4, 0.02, 2});
%! said = limit_warnings (limits, "arm: ", "take less");
%! assert (said, {["arm: the slope v2,1 reaches 0.4, the theory holds for small ones, here up to 0.2: errors of its" ...
%!                 " square are 0.08; take less"], ...
%!                ["arm: the axial strain reaches 0.02, linear elasticity holds for small ones: take smaller loads or" ...
%!                 " a larger EA"]});
%!test # at a limit itself nothing
%! assert (limit_warnings (struct ("what", "slope", "limit", 0.2, "reached", 0.2), "", ""), {});
