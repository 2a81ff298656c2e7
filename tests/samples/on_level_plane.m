## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} on_level_plane (@var{field}, @var{value}, @dots{})
## A scene of a rod of 2 m on the level plane, hinged at the origin, along the first axis, with these fields beside.
## @end deftypefn

function scene = on_level_plane (varargin)
  scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
                  "rod", struct ("length", 2, "EA", 30, "EI", 1, "rhoA", 1.5), "ends", {{"hinge", "free"}}, ...
                  "model", struct ("modes", [3 3]), varargin{:});
endfunction

%!assert (check_surface_scene (on_level_plane ("gravity", 0)).gravity, 0)
