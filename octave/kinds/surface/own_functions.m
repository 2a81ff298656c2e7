## -*- texinfo -*-
## @deftypefn {} {@var{own} =} own_functions (@var{scene})
## Base functions that a curved rod has of its own in the chart of a plane, so that it turns, moves and bends there
## without being stretched, however its curvature jumps: what the scene's polynomials lack of its undeformed
## coordinates, over its length, and of the second to sixth power of the way behind each jump.  A struct of count
## (1-by-2, for the chart's coordinates; 0 of other rods), at (i, xi) = a cell of their values, slopes (1/m) and second
## derivatives (1/m^2) at the stations xi (p-by-1, m), and, where there are any, whole (xi), the values without what
## polynomials have of them.  @var{scene} is checked, with numbers of modes.
## @end deftypefn

function own = own_functions (scene)
  own = struct ("count", [0 0], "at", @(i, xi) repmat ({zeros(numel (xi), 0)}, 1, 3));
  if (! isfield (scene, "exact") || isempty (scene.rod.curvature))
    return;
  endif
  l = scene.rod.length;
  [xi, weights] = rod_quadrature (scene);
  bent = @(functions) [functions{1}; l^2*functions{3}].*sqrt (repmat (weights/l, 2, 1));
  axis = rod_axis (scene.rod, 16);
  of_rod = @(xi) functions_of (scene.rod, axis, xi);
  for i = 1:2
    polynomials = @(xi) polynomials_of (scene.model.modes(i), xi, l);
    P = bent (polynomials (xi));
    x = bent (of_rod (xi));
    along = P \ x;
    [~, sizes, turn] = svd (x - P*along, "econ");
    turn = turn(:,diag (sizes) > 1e-6);
    values = beyond_polynomials (of_rod (xi), polynomials (xi), along, turn){1};
    turn ./= sqrt (weights.'*values.^2/l);
    own.count(i) = columns (turn);
    beyond{i} = @(xi) beyond_polynomials (of_rod (xi), polynomials (xi), along, turn);
  endfor
  own.at = @(i, xi) beyond{i}(xi);
  own.whole = @(xi) of_rod (xi){1};
endfunction

function functions = beyond_polynomials (functions, polynomials, along, turn)
  for k = 1:3
    functions{k} = (functions{k} - polynomials{k}*along)*turn;
  endfor
endfunction

function functions = functions_of (rod, axis, xi)
  l = rod.length;
  [x, y, theta] = undeformed_places (struct ("axis", axis), xi);
  tangent = [cos(theta); sin(theta)].';
  functions = {[x; y].'/l, tangent/l, curvature_at(rod, xi(:)).*[-tangent(:,2), tangent(:,1)]/l};
  behind = max (xi(:) - rod.curvature_breaks(:).', 0)/l;
  for k = 2:6
    functions{1} = [functions{1}, behind.^k];
    functions{2} = [functions{2}, k*behind.^(k-1)/l];
    functions{3} = [functions{3}, k*(k - 1)*behind.^(k-2).*(behind > 0)/l^2];
  endfor
endfunction

function functions = polynomials_of (n, xi, length)
  functions = cell (1, 3);
  [functions{:}] = legendre_functions (n, xi, length);
endfunction

%!function scene = exact_one (of, modes)
%!  scene = exact_kind ().check (exact_scene (check_scene (of)));
%!  scene.model.modes = modes;
%!endfunction
%!test # with the polynomials they make the rod, wherever it is turned; derivatives, by differences
%! scene = exact_one (setfield (hook (), "initial", "phi", 0.3), [5 6]);
%! own = own_functions (scene);
%! assert (own.count > 2);
%! xi = scene.rod.length*[0.1; 0.3; 0.5; 0.6; 0.8; 1]; axis = rod_axis (scene.rod, 16);
%! [x, y] = undeformed_places (struct ("axis", axis), xi);
%! for i = 1:2
%!   base = @(xi) [legendre_functions(4 + i, xi, scene.rod.length), own.at(i, xi){1}];
%!   fine = linspace (0, scene.rod.length, 200).';
%!   [fine_x, fine_y] = undeformed_places (struct ("axis", axis), fine);
%!   assert (base (xi)*(base (fine) \ [fine_x; fine_y].'), [x; y].', 1e-10);
%!   found = own.at (i, 0.7 + [0; 1e-4; -1e-4]);
%!   [values, slopes, seconds] = found{:};
%!   assert ((values(2,:) - values(3,:))/2e-4, slopes(1,:), 1e-3);
%!   assert ((slopes(2,:) - slopes(3,:))/2e-4, seconds(1,:), 1e-2);
%! endfor
%!test # of a smooth arc with many polynomials, of a straight rod and of one on a surface there are none
%! assert (own_functions (exact_one (arc_pendulum (), [16 8])).count, [0 2]);
%! none = own_functions (exact_one (swing (), [4 4]));
%! assert (none.count, [0 0]); assert (size (none.at (1, [0; 1]){2}), [2 0]);
%! assert (own_functions (setfield (check_surface_scene (large_swing ()), "model", "modes", [4 4])).count, [0 0]);
