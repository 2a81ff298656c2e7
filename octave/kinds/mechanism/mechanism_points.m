## -*- texinfo -*-
## @deftypefn {} {@var{points} =} mechanism_points (@var{mechanism}, @var{history})
## The centrelines of a mechanism's bodies at the times of its @var{history} (see @code{measure_mechanism}): a struct
## of x and y (11 stations of each body by times, m).
## @end deftypefn

function points = mechanism_points (mechanism, history)
  points = struct ("x", [], "y", []);
  for k = 1:numel (history.bodies)
    model = mechanism.models{k};
    [x, y] = body_centreline (model, linspace (0, model.length, 11), history.bodies(k), 1);
    points.x = [points.x; x];
    points.y = [points.y; y];
  endfor
endfunction

%!test # two rods, end to end
%! [system, start] = sample_mechanism ([0 1]);
%! history = measure_mechanism (system, 0, start);
%! points = mechanism_points (system.mechanism, history);
%! assert (size (points.x), [33 1]);
%! assert ([points.x(11), points.y(11)], [points.x(12), points.y(12)], 1e-10);
