## -*- texinfo -*-
## @deftypefn {} {[@var{figures}, @var{units}] =} rest_figures (@var{found})
## What OBSERVE may ask of an equilibrium that @code{statics} has @var{found}, as @code{statics.tip_x(2)}: a struct of
## stable (0 or 1), slowest (rad/s), growth (1/s), tip_x, tip_y, on a surface tip_z (m), a number each body, and what
## holds it, reaction_x, reaction_y, torque and so on, a number each joint that has one.  @var{units} has the same
## fields, each " [m]" or "".
## @end deftypefn

function [figures, units] = rest_figures (found)
  figures = struct ("stable", double (found.stable), "slowest", found.slowest, "growth", ...
                    max (found.vibrations.rate));
  units = struct ("stable", "", "slowest", " [rad/s]", "growth", " [1/s]");
  tips = cell2mat (cellfun (@(places) places(end,:), found.shape(:), "uniformoutput", false));
  for k = 1:columns (tips)
    name = ["tip_" "xyz"(k)];
    figures.(name) = tips(:,k).';
    units.(name) = " [m]";
  endfor
  for row = found.supports.'
    [name, unit] = regexp (row{1}, '^\w+', "match", "split", "once");
    figures.(name) = [field_or(figures, name, []), row{2} + 0];  # no -0
    units.(name) = [" " regexp(unit{end}, '\[.*\]$', "match", "once")];
  endfor
endfunction

%!test
%! found = struct ("stable", true, "slowest", 3, "vibrations", struct ("rate", [0 0]), ...
%!                 "shape", {{[0 0; 1 2], [1 2; 3 4]}}, ...
%!                 "supports", {{"reaction_x of hinge [N]", 6; "torque of hinge [N m]", 7; "reaction_x of b [N]", 8}});
%! [figures, units] = rest_figures (found);
%! assert (figures, struct ("stable", 1, "slowest", 3, "growth", 0, "tip_x", [1 3], "tip_y", [2 4], ...
%!                          "reaction_x", [6 8], "torque", 7));
%! assert ({units.tip_x, units.reaction_x, units.torque, units.stable}, {" [m]", " [N]", " [N m]", ""});
