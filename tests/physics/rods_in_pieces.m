## -*- texinfo -*-
## @deftypefn {} {@var{deflection} =} rods_in_pieces (@var{count})
## Of the tip of a cantilever under P l^2/EI = 1, in so many pieces, per its length, for the test of this file.
## @end deftypefn

function deflection = rods_in_pieces (count)
  scene.rod = struct ("length", 2, "EA", 2e9, "EI", 2e6, "rhoA", 80, "half_height", 0.05);
  [scene.rotation, scene.force, scene.gravity, scene.duration] = deal (@(t) [0 0 0], [0 -5e5], 0, 1);
  scene.model.energy = "uniaxial";
  evalc ("rest = statics (scene, 'output', '', 'pieces', count);");
  deflection = -rest.shape{end}(end,2)/2;
endfunction

%!test # 0.30172 (Bisshopp and Drucker 1945), the nearer to it the more pieces
%! off = arrayfun (@rods_in_pieces, [1 4]) - 0.30172;
%! assert (off(2), 0, 3e-3); assert (abs (off(1)) > 8*abs (off(2)));
