## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} unit_rod (@var{field}, @var{value}, @dots{})
## A scene of a rod of unit length, mass and EI for a second, with each @var{field}, as "gravity" or "rod.EA", of the
## @var{value} behind it.
## @end deftypefn

function scene = unit_rod (varargin)
  scene.rod = struct ("length", 1, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.005);
  scene.duration = 1;
  for k = 1:2:numel (varargin)
    scene = setfield (scene, strsplit (varargin{k}, "."){:}, varargin{k+1});
  endfor
endfunction

%!assert (check_scene (unit_rod ("rod.EA", 3, "gravity", 0)).rod.EA, 3)
%!assert (unit_rod ("gravity", 0).gravity, 0)
