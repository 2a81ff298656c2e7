## -*- texinfo -*-
## @deftypefn {} {@var{found} =} statics (@var{scene}, @var{option}, @var{value}, @dots{})
## Where a scene of any kind comes to rest under its loads: the equilibrium that it falls to from its start (see
## @code{at_rest}), at the time that the option "time" has (s, default 0), at which what a hub or a joint prescribes
## stays.  Other arguments as for @code{driver}; without stated modes there are as many base functions as places within
## 1e-6 of their distances take.
##
## Leaves shape.csv (41 places of each rod), along.csv (force, moment and stress there, see @code{section_forces} and
## @code{surface_section}), statics.csv (figures) and pictures, shape.svg, along.svg and both as .png, in the folder of
## the scene's output.  @var{found} is what @code{at_rest} returns, with shape, along, supports (see
## @code{mechanism_at_rest}), stable (whether no mode grows) and slowest (rad/s, the slowest vibration).
##
## The option "factor", at least two rising numbers, asks for the equilibria under so many times the forces and moments
## of the scene and of its joints at that time; its weight, and what is prescribed, stay.  @var{found} is then the path
## of @code{load_path}: what turns it unstable is said, and path.csv, path.svg and path.png are left instead.
##
## @example
## found = statics ("roof", "factor", 0:0.05:1.2);
## @end example
## @end deftypefn

function found = statics (scene = "paper", varargin)
  [time, options] = taken_time (varargin);
  [factors, options] = taken_option (options, "factor", [], @are_factors, ...
                                     "two rising numbers or more, FACTOR=0:0.05:2");
  [scene, kind, output, left] = study_scene (scene, options, @scene_at_rest);
  if (isempty (factors))
    result = one_rest (kind, scene, output, time);
  else
    result = path_of_rests (kind, scene, output, time, factors, left);
  endif
  if (nargout > 0)
    found = result;
  endif
endfunction

function good = are_factors (factors)
  good = isreal (factors) && isvector (factors) && numel (factors) > 1 && all (isfinite (factors)) ...
         && all (diff (factors) > 0);
endfunction

function result = one_rest (kind, scene, output, time)
  result = at_rest (kind, scene, time, @(found) vertcat (found.balance.shape (found.q){:})(:).');
  result.shape = result.balance.shape (result.q);
  result.along = result.balance.along (time, result.q, result.lambda);
  result.supports = result.balance.supports (time, result.q, result.lambda);
  result.stable = ! any (result.vibrations.rate);
  result.slowest = [result.vibrations.omega, Inf](1);
  describe (result, time);
  publish_study (output, {"shape.csv", "along.csv", "statics.csv"}, ...
                 {"shape.svg", "shape.png", "along.svg", "along.png"}, ...
                 @(aside) write_tables (result, time, aside), ...
                 @(scratch) draw_shapes ("shape", panel_of (result), scene, scratch), ...
                 @(scratch) draw_along (result.along, result.balance.names, scene.title, scratch));
endfunction

function write_tables (result, time, folder)
  write_statics (result, time, folder);
  write_along (result.along, folder);
endfunction

function path = path_of_rests (kind, scene, output, time, factors, left)
  path = load_path (kind, scene, time, factors, left);
  for event = path.events
    say ("  %.9g times the loads: %s", event.factor, event.what);
  endfor
  say ("  the path ends %s", path.end);
  publish_study (output, {"path.csv"}, {"path.svg", "path.png"}, @(aside) write_path (path, aside), ...
                 @(scratch) draw_path (path, scene, scratch));
endfunction

function describe (found, time)
  how = "of the stated modes";
  warnings = {};
  if (! isnan (found.functions))
    [off, share] = last_doubling (found);
    how = sprintf ("of %d base functions of each sort: half as many move a place by %.1g m", found.functions, off);
    warnings = slowly_converging (share, "a place by %.2g of the longest way to the equilibrium");
  endif
  say ("  equilibrium under the loads at t = %g s, %s", time, how);
  cellfun (@(text) say ("warning: %s", text), warnings);
  if (! found.stable)
    say ("warning: it is unstable: what is beside it goes away as exp (%.4g t)", ...
         max (found.vibrations.rate));
  elseif (isinf (found.slowest))
    say ("  its joints hold all of it");
  elseif (found.slowest == 0)
    say ("  something moves without coming back: the equilibrium is one of many");
  else
    say ("  stable: the slowest vibration about it has %.6g Hz", found.slowest/(2*pi));
  endif
  for k = 1:numel (found.shape)
    say ("  %s: tip at (%s) m", found.balance.names{k}, strjoin (cellfun (
         @(x) sprintf ("%.9g", x), num2cell (found.shape{k}(end,:)), "uniformoutput", false), ", "));
  endfor
  for row = found.supports.'
    say ("  %s: %.9g", row{1}, row{2} + 0);  # no -0
  endfor
endfunction

function panel = panel_of (found)
  panel = struct ("title", "start (grey) and equilibrium", "faint", {found.balance.shape(found.balance.placed)}, ...
                  "strong", {found.shape});
endfunction

%!error <time is -1: it takes a time in s> statics ("swing", "time", -1)
%!test # the rod hangs, stretched by its weight, and the table has where
%! [folder, gone] = scratch_folder ();
%! said = evalc ("found = statics ('swing', 'output', folder);");
%! assert (found.stable); assert (found.shape{1}(end,1), 0, 1e-9);
%! csv = csvread (fullfile (folder, "shape.csv"), 1, 1);
%! assert (csv(end,1:3), [1, found.shape{1}(end,:)], 1e-15);
%! assert (stat (fullfile (folder, "shape.png")).size > 5000);
%! assert (stat (fullfile (folder, "along.png")).size > 5000);
%! along = csvread (fullfile (folder, "along.csv"), 1, 1);
%! assert (along(1,2), 0.04*0.04*0.5*7800*9.81, 1e-9);
%! assert (! isempty (strfind (said, "stable: the slowest vibration about it has")));
%!error <factor is 2: it takes two rising numbers or more> statics ("two_link_arm", "factor", 2)
%!error <factor is 0   2   1: it takes two rising> statics ("two_link_arm", "factor", [0 2 1])
%!error <no force and no moment at t = 0 s that a factor could multiply> statics ("swing", "factor", 0:1)
%!test # a path, its table and its picture
%! [folder, gone] = scratch_folder ();
%! said = evalc ("found = statics ('roof', 'factor', [0 2], 'modes', [1 0], 'output', folder);");
%! assert ({found.events.what}, {"limit point", "limit point"});
%! assert (! isempty (strfind (said, sprintf ("  %.9g times the loads: limit point\n", found.events(1).factor))));
%! assert (! isempty (strfind (said, "the path ends at 2 times the loads, the last factor")));
%! csv = csvread (fullfile (folder, "path.csv"), 1, 0);
%! assert (csv(:,1).', found.factor, 1e-15);
%! assert (stat (fullfile (folder, "path.png")).size > 10000);
%!function [warned, tip] = of_stem (varargin)   # 1 m on two bearings, a stem of 0.5 m on its middle is pushed aside
%!  rod = @(length) struct ("rod", struct ("length", length, "EA", 1e6, "EI", 100, "rhoA", 1));
%!  scene.bodies = {rod(1), setfield(rod (0.5), "initial", struct ("x", 0.5, "phi", pi/2))};
%!  at = @(kind, bodies, stations, varargin) struct ("kind", kind, "bodies", bodies, "stations", stations, varargin{:});
%!  scene.joints = {at("revolute", 1, 0), at("slider", 1, 1, "point", [1 0], "direction", 0), ...
%!                  at("weld", [2 1], [0 0.5]), at("force", 2, 0.5, "value", [0.1 0])};
%!  [scene.gravity, scene.duration] = deal (0, 1);
%!  said = evalc ("found = statics (scene, 'output', '', varargin{:});");
%!  [warned, tip] = deal (! isempty (strfind (said, "converge slowly")), found.shape{end}(end,1) - 0.5);
%!endfunction
%!test # where a rod is bent within its length it is said that functions converge slowly; pieces do not
%! expected = 0.1*(0.5^3/300 + 0.5^2/1200);  # of the stem, and of the bar that turns its root
%! [warned, tip] = of_stem ();
%! assert (warned && abs (tip - expected) > 1e-3*expected);
%! [warned, tip] = of_stem ("pieces", 2);
%! assert (! warned); assert (tip, expected, 1e-3*expected);
