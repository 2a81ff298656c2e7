## -*- texinfo -*-
## @deftypefn {} {@var{outline} =} body_outline (@var{x}, @var{y}, @var{half_height})
## The closed polygon (2P+1-by-2, m) around the centreline @var{x}, @var{y} (P-by-1, m) at the distance
## @var{half_height} (m).
## @end deftypefn

function outline = body_outline (x, y, half_height)
  tangent = [gradient(x), gradient(y)];
  normal = half_height * [-tangent(:,2), tangent(:,1)] ./ hypot (tangent(:,1), tangent(:,2));
  upper = [x, y] + normal;
  outline = [upper; flipud([x, y] - normal); upper(1,:)];
endfunction

%!test
%! outline = body_outline ([0; 1; 2], [0; 0; 0], 0.5);
%! assert (outline, [0 0.5; 1 0.5; 2 0.5; 2 -0.5; 1 -0.5; 0 -0.5; 0 0.5]);
%! outline = body_outline ([0; 0; 0], [0; 1; 2], 0.5);
%! assert (outline, [-0.5 0; -0.5 1; -0.5 2; 0.5 2; 0.5 1; 0.5 0; -0.5 0]);
