## What a run of the paper's scene has left in FOLDER, examined from outside.

function verify (name, good, value)
  if (good)
    printf ("ok %s\n", name);
  else
    printf ("not ok %s: %g\n", name, value);
  endif
endfunction

folder = getenv ("FOLDER");
table = csvread (fullfile (folder, "history.csv"), 1, 0);
column = @(k) table(:,k);
[T, U, Z, W, D] = deal (column (21), column (22), column (23), column (24), column (25));
balance = T + U + Z + D - W;
relative = norm (balance - balance(1), Inf)/max (range ([T, U, Z, W, D]));
verify ("energy balance within 1e-7 of what changes over 1.8 s", relative <= 1e-7, relative);
verify ("a row for each of the 91 frame times", rows (table) == 91 && table(end,1) == 1.8, rows (table));
frames = numel (glob (fullfile (folder, "frames", "frame_*.png")));
verify ("as many frames as rows", frames == rows (table), frames);
after = column (1) >= 0.3;
work = norm (diff (W(after)), Inf);
verify ("the moment does no work after 0.3 s", work < 1e-6*max (W), work);
[phi, phi_dot, tip_x, tip_y] = deal (column (2), column (3), column (5), column (6));

## of the longitudinal equilibrium: the rod of (14), whose bending does not shorten it, is as long as its pull makes it
E = 4*(1.2e11 + 8.1e10);
stretch = 7800*phi_dot.^2/(3*E) - 7800*9.81*sin (phi)/(2*E);
off = norm (hypot (tip_x, tip_y) - 1 - stretch, Inf)/norm (stretch, Inf);
verify ("the tip is as far out as rotation and weight stretch the rod, within a quarter of that", off < 0.25, off);

## of the first sine, as 90 N m and the weight, less the inertia that they move, hold it
at_jump = find (column (1) == 0.3);
EI = (1.2e11 + 2*8.1e10)*0.02*0.03^3/12;
bent = 2/(pi^4*EI)*(90*(pi - 3/pi) - 4.68*9.81*cos (phi(at_jump))/(2*pi));
off = abs (column (14)(at_jump)/bent - 1);
verify ("the rod is bent as the moment bends it before it stops, within 3 %", off < 0.03, off);
