## -*- texinfo -*-
## @deftypefn {} {@var{tip} =} undeformed_tip (@var{model})
## Where the tip of the undeformed rod is against O, along the tangent there and, as the imaginary part, across it (m).
## @end deftypefn

function tip = undeformed_tip (model)
  [x, y] = undeformed_places (model.base, model.length);
  [~, ~, tilt] = undeformed_places (model.base, 0);
  tip = (x + 1i*y)*exp (-1i*tilt);
endfunction

%!assert (undeformed_tip (struct ("base", struct ("length", 2), "length", 2)), 2)
