## -*- texinfo -*-
## @deftypefn {} {@var{panels} =} surface_panels (@var{scene}, @var{history})
## What @file{history.svg} shows of a rod on a surface that was observed by @code{measure_surface}, from top to bottom:
## a struct array of panels (see @code{new_panel}).
## @end deftypefn

function panels = surface_panels (scene, history)
  tip = without_zeros (new_panel ("tip", "m", {"x", "y", "z"}, history.tip));
  reaction = new_panel ("reaction", "N/m", {"smallest", "largest"}, ...
                        [min(history.reaction, [], 1); max(history.reaction, [], 1)]);
  if (max (abs (history.reaction(:))) < 1e-12*scene.rod.EA/scene.rod.length)
    reaction = [];  # rounding, as on an upright plane
  endif
  momentum = without_zeros (new_panel ("angular momentum", "kg m²/s", {"x", "y", "z"}, history.angular_momentum));
  panels = [tip, reaction, energy_panels(history), momentum];
endfunction

%!test # a reaction that is rounding is left out
%! momentum = [0 0; 0 0; 1 2];
%! history = struct ("tip", [1 2; 3 4; 0 0], "reaction", 1e-9*[1 2; 3 4], "angular_momentum", momentum, ...
%!                   "T", [0 1], "U", [0 0], "Z", [1 0], "W", [0 0], "D", [0 0], "balance", [1 1]);
%! scene.rod = struct ("EA", 1e6, "length", 1);
%! assert ({surface_panels(scene, history).label}, {"tip", "energies", "energy balance", "angular momentum"});
%! history.reaction *= 1e9;
%! panels = surface_panels (scene, history);
%! assert (panels(2).values, [1 2; 3 4], 1e-12); assert (panels(1).names, {"x", "y"});
