## -*- texinfo -*-
## @deftypefn {} {@var{err} =} with_remedy (@var{err}, @var{remedy})
## The error @var{err} with one @var{remedy} (a text) more in its message, as @code{rethrow} takes it.
## @end deftypefn

function err = with_remedy (err, remedy)
  err = struct ("message", [strtrim(err.message) "; " remedy "\n"], "identifier", err.identifier, "stack", err.stack);
endfunction

%!function err = error_of (varargin)
%!  try
%!    error (varargin{:});
%!  catch err
%!  end_try_catch
%!endfunction
%!error <^no rod; take two$> rethrow (with_remedy (error_of ("c:d", "no rod\n"), "take two"));
%!error id=c:d rethrow (with_remedy (error_of ("c:d", "no rod\n"), "take two"));
%!function result = steep_run (exact)   # of a rope that swings down
%!  scene = struct ("rod", struct ("length", 1, "EA", 1e4, "EI", 0.01, "rhoA", 0.1), "duration", 0.25);
%!  evalc ("result = driver (scene, 'tolerance', 0.01, 'output', '', 'exact', exact);");
%!endfunction
%!test # where models bend too far the exact rod is run, if there is one
%! assert (kind_of (steep_run ("auto").scene).name, "exact");
%!error <a slope reaches .*; PIECES=4, or the option "pieces", makes each rod>
%! bodies = {struct("rod", struct ("length", 1, "width", 0.02, "half_height", 0.0005), "initial", struct ("V2", 1e-4))};
%! joints = {struct("kind", "weld", "bodies", 1, "stations", 0), ...
%!           struct("kind", "force", "bodies", 1, "stations", 1, "value", @(t) [0, -50*t])};
%! scene = struct ("bodies", {bodies}, "joints", {joints}, "duration", 0.4);
%! evalc ("driver (scene, 'tolerance', 0.01, 'output', '', 'exact', 'auto');");
%!error <a slope reaches .*; EXACT=yes, or the option "exact", takes the geometrically exact rod>
%! steep_run (false);
