## -*- texinfo -*-
## @deftypefn {} {@var{table} =} natural_modes (@var{scene}, @var{option}, @var{value}, @dots{})
## Natural frequencies and modes of a scene of any kind about the equilibrium that it comes to under its loads at t = 0
## (see @code{at_rest}), the slowest twelve: what a hub or a joint prescribes stays as it is then.  Arguments as for
## @code{driver}; without stated modes there are as many base functions as six digits take.  The option "film" (numbers
## of modes) leaves films of those, too (see @code{film_mode}).
##
## The option "time" (s) asks for those about the state that a run of the scene has then, with frozen coefficients and
## the modes of the run, instead (see @code{at_state}): where a mode is fast against the motion, that is how it rings.
##
## Leaves modes.csv, modes.svg and modes.png (the slowest six, both ways) in the folder of the scene's output (the
## option "output"; "" leaves nothing).  @var{table} is a struct array of mode, f (Hz), omega (rad/s), damping (ratio),
## growth (1/s, of what is unstable), change (of omega when the base functions were doubled, relative) and share (of
## the kinetic energy, of each body).
## @end deftypefn

function table = natural_modes (scene = "paper", varargin)
  [films, options] = taken_option (varargin, "film", [], @are_numbers, "numbers of modes, from 1 to 12");
  [time, options] = taken_time (options, []);
  if (isempty (time))
    [scene, kind, output] = study_scene (scene, options, @scene_at_rest);
    found = at_rest (kind, scene, 0, @(found) found.vibrations.omega(1:min (end, 12)));
  else
    [scene, kind, output] = study_scene (scene, options, @scene_of_bodies);
    found = at_state (kind, scene, time);
    found.change = found.change(1:min (end, 12));
  endif
  rows = mode_rows (found);
  print_rows (rows, found);
  publish_study (output, {"modes.csv"}, {"modes.svg", "modes.png"}, ...
                 @(aside) write_modes (rows, found.balance.names, aside), ...
                 @(scratch) draw_shapes ("modes", mode_panels (rows, found), scene, scratch));
  if (isempty (output.folder) || ! output.pictures)
    films = [];
  endif
  for k = films(films <= numel (rows))(:).'  # 0-by-0 goes round once in Octave 11
    film_mode (output, scene, found, k, title_of (rows(k)));
  endfor
  if (nargout > 0)
    table = rows;
  endif
endfunction

function good = are_numbers (k)
  good = isreal (k) && isrow (k) && all (k == fix (k) & k >= 1 & k <= 12);
endfunction

function rows = mode_rows (found)
  rows = struct ([]);
  modes = found.vibrations;
  for k = 1:numel (found.change)
    shape = found.linear.basis*modes.shape(:,k);
    energies = shape.*(found.linear.mass*shape);
    share = cellfun (@(body) sum (energies(body)), found.balance.bodies)/sum (energies);
    rows(k) = struct ("mode", k, "f", modes.omega(k)/(2*pi), "omega", modes.omega(k), "damping", modes.damping(k), ...
                      "growth", modes.rate(k), "change", found.change(k), "share", share);
  endfor
endfunction

function print_rows (rows, found)
  if (isfield (found, "v"))
    say ("  of the modes of the run up to t = %g s, about its state then, with frozen coefficients", found.time);
  elseif (isnan (found.functions))
    say ("  of the stated modes");
  else
    say ("  of %d base functions of each sort", found.functions);
  endif
  for row = rows
    say ("  %3d %14.8g Hz %14.8g rad/s  damping ratio %-8.3g %s", row.mode, row.f, row.omega, row.damping, ...
         kind_text (row));
  endfor
endfunction

function text = kind_text (row)
  text = "";
  if (isfinite (row.change))
    text = sprintf ("changed by %.1g", row.change);
  endif
  if (row.growth > 0)
    text = sprintf ("unstable: grows by exp (%.4g t)", row.growth);
  elseif (row.omega == 0)
    text = "nothing brings it back";
  endif
endfunction

## the slowest six, by an eighth of the picture to both sides
function panels = mode_panels (rows, found)
  panels = struct ([]);
  for row = rows(1:min (end, 6))
    step = found.linear.basis*found.vibrations.shape(:,row.mode);
    [rest, back, ahead] = pushed_lines (found.balance, found.q, step);
    panels(end+1) = struct ("title", title_of (row), "faint", {[rest, back]}, "strong", {ahead});
  endfor
endfunction

function title = title_of (row)
  title = sprintf ("%d: %.4g Hz", row.mode, row.f);
  if (row.growth > 0)
    title = sprintf ("%d: unstable", row.mode);
  endif
endfunction

%!error <time is soon: it takes a time in s, not negative> natural_modes ("paper", "time", "soon")
%!test # about the state of a run: as many as it has modes
%! [folder, gone] = scratch_folder ();
%! said = evalc ("table = natural_modes ('spin_up', 'time', 0.5, 'modes', [0 2], 'output', folder);");
%! assert (numel (table), 2); assert (isnan ([table.change]));
%! assert (! isempty (strfind (said, "of the modes of the run up to t = 0.5 s")));
%!test # no folder, no film
%! evalc ("natural_modes ('swing', 'modes', [0 1], 'film', 1, 'output', '');");
%!error <cannot be made|can be written> natural_modes ("paper", "output", "/proc/nowhere")
%!test # a rod swings about its hinge, and bends; table and pictures are there
%! [folder, gone] = scratch_folder ();
%! said = evalc ("table = natural_modes ('slender', 'output', folder);");
%! assert (table(1).omega, sqrt (1.5*9.81), -0.01);  # nearly that of a rigid one of 1 m
%! assert ([table(1:3).change] <= 1e-5); assert (table(2).share, 1, 1e-12);
%! lines = strsplit (strtrim (fileread (fullfile (folder, "modes.csv"))), "\n");
%! assert (lines{1}, "mode,f [Hz],omega [rad/s],damping ratio,growth [1/s],change,share of body 1");
%! assert (str2double (strsplit (lines{3}, ","){3}), table(2).omega, -1e-15);
%! assert (stat (fullfile (folder, "modes.png")).size > 10000);
%! assert (! isempty (regexp (said, sprintf ("%.8g Hz", table(2).f))));
%!test # upright it falls, by exp (sqrt (3 g/(2 l)) t)
%! scene = setfield (setfield (slender (), "initial", "phi", pi/2), "gravity", 0.1);
%! said = evalc ("table = natural_modes (scene, 'modes', [0 0], 'output', '');");
%! assert (table.growth, sqrt (0.15), 1e-6); assert (! isempty (strfind (said, "unstable: grows by exp (0.3873 t)")));
%!test # a damper at a joint of geometrically exact rods, of 32 polynomials each, leaves the slow modes where they are
%! rod = struct ("length", 0.4, "width", 0.02, "half_height", 0.004);
%! scene.bodies = {struct("rod", rod, "initial", struct ("phi", -pi/2)), struct("rod", rod)};
%! scene.bodies{2}.initial = scene.bodies{1}.initial;
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [0.4 0])
%!                 struct("kind", "torsion_spring", "bodies", [1 2], "stations", [0.4 0], "stiffness", 20)};
%! scene.duration = 1;
%! evalc ("free = natural_modes (scene, 'exact', true, 'output', '');");
%! scene.joints{3}.damping = 0.01;
%! evalc ("damped = natural_modes (scene, 'exact', true, 'output', '');");
%! assert ([damped(1:2).f], [free(1:2).f], -2e-4); assert (damped(2).damping, 0.0138, 1e-4);
