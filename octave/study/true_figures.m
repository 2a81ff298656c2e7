## -*- texinfo -*-
## @deftypefn {} {@var{figures} =} true_figures (@var{result})
## How far the points of a @var{result} of @code{driver} truly are off in any frame, against @code{far_richer}: a struct
## of error_m, and of smaller_m, the least that the next smaller models of one straight rod are off (NaN for others).
## Without a result both are NaN.
## @end deftypefn

function figures = true_figures (result)
  figures = struct ("error_m", NaN, "smaller_m", NaN);
  if (nargin == 0)
    return;
  endif
  reference = far_richer (result);
  figures.error_m = distance (result, reference);
  ladder = ladder_of (kind_of (result.scene), result.scene);
  if (iscellstr (ladder.parts) && ismember ("stiffening", ladder.parts))
    for part = ladder.parts
      rung = ladder.smaller (result.model.rung, part{1});
      if (! isequal (rung, result.model.rung))
        figures.smaller_m = min (figures.smaller_m, distance (try_rung (ladder, rung), reference));
      endif
    endfor
  endif
endfunction

%!test # a rod that swings: as the run says, and what it left out would have been needed
%! scene = setfield (setfield (swing (), "duration", 0.3), "solver", "tolerance", 1e-7);
%! evalc ("result = driver (scene, 'output', ''); figures = true_figures (result);");
%! assert (figures.error_m > 0.05e-7 && figures.error_m <= 1e-7);
%! assert (result.summary.estimated_error_m > 0.3*figures.error_m);
%! assert (result.summary.estimated_error_m < 10*figures.error_m); assert (figures.smaller_m > 0.95e-7);
%!test # of a mechanism there are no smaller models
%! scene = setfield (setfield (chain (2), "duration", 0.02), "model", "modes", "auto");
%! evalc ("result = driver (scene, 'output', ''); figures = true_figures (result);");
%! assert (isnan ([figures.error_m, figures.smaller_m]), [false true]);
%!assert (true_figures (), struct ("error_m", NaN, "smaller_m", NaN))
