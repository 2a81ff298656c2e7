## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_stability (@var{pictures}, @var{scratch})
## The @var{pictures} of @code{stability} with the regions of stability, stability.svg and stability.png beside the
## folder @var{scratch}, which takes the data.  They are there when @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_stability (pictures, scratch)
  text = gnuplot_settings (struct ("ode45_limit", stability_limit ("ode45"), "ode23_limit", stability_limit ("ode23")));
  for method = {"rk4", "ode45", "ode23"}
    text = [text, gnuplot_block([method{1} "_region"], {region(method{1})})];
  endfor
  system = free_rod ([7 7], struct ());
  [~, squares] = free_modes (system.stiffness, system.mass);
  omegas = sqrt (max (squares, 0));
  marks = omegas(2:end)/omegas(end)*stability_limit ("rk4");
  text = [text, gnuplot_block("marks", {[zeros(size (marks)), marks]})];
  for [rows, name] = pictures
    text = [text, gnuplot_block(name, {rows})];
  endfor
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "stability.gp");
endfunction

## where |R (z)| = 1
function points = region (method)
  [re, im] = meshgrid (linspace (-5, 2, 281), linspace (0, 5, 201));
  c = contourc (re(1,:), im(:,1), abs (polyval (stability_function (method), re + 1i*im)), [1 1]);
  points = zeros (0, 2);
  while (! isempty (c))
    points = [points; c(:,1+(1:c(2,1))).'; NaN NaN];
    c(:,1:1+c(2,1)) = [];
  endwhile
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! pair = [1 1; 2 2];
%! wall = [1e-3 1 1e-4; 1e-4 0.5 1e-5];
%! pictures = struct ("damping", pair/3, "ode45_wall", wall, "ode23_wall", wall, "resonances", pair, ...
%!                    "trigonometric", pair, "stormer_verlet", pair, "implicit_midpoint", pair);
%! draw = {@(scratch) draw_stability(pictures, scratch)};
%! assert (draw_files (folder, draw, {"stability.svg", "stability.png"}), cell (0, 2));
%!function text = settings_of (pictures, scratch)
%!  finish_tool (draw_stability (pictures, scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # regions have their limits on the axes, where the classical method has 2.785 and 2.828, and marks end there
%! pair = [1 1; 2 2];
%! wall = [1e-3 1 1e-4; 1e-4 0.5 1e-5];
%! pictures = struct ("damping", pair/3, "ode45_wall", wall, "ode23_wall", wall, "resonances", pair, ...
%!                    "trigonometric", pair, "stormer_verlet", pair, "implicit_midpoint", pair);
%! text = in_scratch (@(folder, scratch) settings_of (pictures, scratch));
%! points_of = @(name) str2num (regexp (text, ['\$' name ' << END\n(.*?)\nEND'], "tokens", "once"){1});
%! points = points_of ("rk4_region");
%! leftmost = min (points(points(:,2) < 0.02,1));
%! highest = max (points(abs (points(:,1)) < 0.02,2));
%! assert ([leftmost, highest], [-2.785, 2.828], 0.01);
%! marks = points_of ("marks");
%! assert (marks(:,1), zeros (14, 1)); assert (marks(end,2), 2.828, 1e-3); assert (marks(1,2) > 0);
%! assert (points_of ("damping"), pair/3, 1e-6); assert (points_of ("ode23_wall"), wall, 1e-9);
%! assert (str2double (regexp (text, "ode23_limit = (\\S+)", "tokens", "once"){1}), sqrt (3), 1e-4);
