## -*- texinfo -*-
## @deftypefn {} {} write_stability (@var{table}, @var{pictures}, @var{folder})
## The @var{table} of @code{stability} as stability.csv, and its @var{pictures} with the regions of stability as
## stability.svg and stability.png.
## @end deftypefn

function write_stability (table, pictures, folder)
  lines = {"method,what,predicted,measured"};
  for row = table
    lines{end+1} = sprintf ("\"%s\",\"%s\",%.17g,%.17g", row.method, row.what, row.predicted, row.measured);
  endfor
  write_text (fullfile (folder, "stability.csv"), [strjoin(lines, "\n") "\n"]);

  scratch = fullfile (folder, "scratch");
  mkdir (scratch);
  text = "";
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
  finish_tool (start_gnuplot (scratch, "stability.gp"));
  confirm_recursive_rmdir (false, "local");
  rmdir (scratch, "s");
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
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   pair = [1 1; 2 2];
%!   wall = [1e-3 1 1e-4; 1e-4 0.5 1e-5];
%!   write_stability (struct ("method", "rk4", "what", "limit", "predicted", 2.8, "measured", 2.8), ...
%!                    struct ("damping", pair/3, "ode45_wall", wall, "ode23_wall", wall, "resonances", pair, ...
%!                            "trigonometric", pair, "stormer_verlet", pair, "implicit_midpoint", pair), folder);
%!   assert (sort ({dir(folder).name}), {".", "..", "stability.csv", "stability.png", "stability.svg"});
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
