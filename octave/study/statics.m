## -*- texinfo -*-
## @deftypefn {} {@var{found} =} statics (@var{scene}, @var{option}, @var{value}, @dots{})
## Where a scene of any kind comes to rest under its loads: the equilibrium that it falls to from its start (see
## @code{at_rest}), at the time that the option "time" has (s, default 0), at which what a hub or a joint prescribes
## stays.  Other arguments as for @code{driver}; without stated modes there are as many base functions as places within
## 1e-6 of their distances take.
##
## Leaves shape.csv (41 places of each rod), statics.csv (figures), shape.svg and shape.png in the folder of the
## scene's output.  @var{found} is what @code{at_rest} returns, with shape, supports (see @code{mechanism_at_rest}),
## stable (whether no mode grows) and slowest (rad/s, the slowest vibration).
## @end deftypefn

function found = statics (scene = "paper", varargin)
  [time, options] = taken_option (varargin, "time", 0, @(t) isscalar (t) && isreal (t) && isfinite (t) && t >= 0, ...
                                  "a time in s, not negative");
  [scene, kind, output] = study_scene (scene, options, @scene_at_rest);
  result = at_rest (kind, scene, time, @(found) vertcat (found.balance.shape (found.q){:})(:).');
  result.shape = result.balance.shape (result.q);
  result.supports = result.balance.supports (time, result.q, result.lambda);
  result.stable = ! any (result.vibrations.rate);
  result.slowest = result.vibrations.omega(1);
  describe (result, time);
  publish_study (output, {"shape.csv", "statics.csv"}, {"shape.svg", "shape.png"}, ...
                 @(aside) write_statics (result, time, aside), ...
                 @(scratch) draw_shapes ("shape", panel_of (result), scene, scratch));
  if (nargout > 0)
    found = result;
  endif
endfunction

function describe (found, time)
  how = "of the stated modes";
  if (! isnan (found.functions))
    how = sprintf ("of %d base functions of each sort: half as many move a place by %.1g of its coordinates", ...
                   found.functions, max (found.change));
  endif
  say ("  equilibrium under the loads at t = %g s, %s", time, how);
  if (! found.stable)
    say ("warning: it is unstable: what is beside it goes away as exp (%.4g t)", ...
         max (found.vibrations.rate));
  elseif (found.slowest == 0)
    say ("  something moves without coming back: the equilibrium is one of many");
  else
    say ("  stable: the slowest vibration about it has %.6g Hz", found.slowest/(2*pi));
  endif
  for k = 1:numel (found.shape)
    printf ("  %s: tip at (%s) m\n", found.balance.names{k}, strjoin (cellfun (
            @(x) sprintf ("%.9g", x), num2cell (found.shape{k}(end,:)), "uniformoutput", false), ", "));
  endfor
  for row = found.supports.'
    printf ("  %s: %.9g\n", row{1}, row{2} + 0);  # no -0
  endfor
endfunction

function panel = panel_of (found)
  panel = struct ("title", "start (grey) and equilibrium", "faint", {found.balance.shape(found.balance.start)}, ...
                  "strong", {found.shape});
endfunction

%!error <time is -1: it takes a time in s> statics ("swing", "time", -1)
%!test # the rod hangs, stretched by its weight, and the table has where
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   said = evalc ("found = statics ('swing', 'output', folder);");
%!   assert (found.stable); assert (found.shape{1}(end,1), 0, 1e-9);
%!   csv = csvread (fullfile (folder, "shape.csv"), 1, 1);
%!   assert (csv(end,1:3), [1, found.shape{1}(end,:)], 1e-15);
%!   assert (stat (fullfile (folder, "shape.png")).size > 5000);
%!   assert (! isempty (strfind (said, "stable: the slowest vibration about it has")));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
