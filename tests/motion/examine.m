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
relative = max (abs (balance - balance(1)))/max (range ([T, U, Z, W, D]));
verify ("energy balance within 1e-7 of what changes over 1.8 s", relative <= 1e-7, relative);
verify ("a row for each of the 91 frame times", rows (table) == 91 && table(end,1) == 1.8, rows (table));
verify ("as many frames as rows", numel (glob (fullfile (folder, "frames", "frame_*.png"))) == 91, 0);
after = column (1) >= 0.3;
work = max (abs (diff (W(after))));
verify ("the moment does no work after 0.3 s", work < 1e-6*max (W), work);
[tip_x, tip_y] = deal (column (5), column (6));
stretch = max (abs (hypot (tip_x, tip_y) - 1));
verify ("the tip stays at the rod's length within 1e-3 m", stretch < 1e-3, stretch);
bent = max (abs (column (14)));
verify ("the rod bends by 0.1 to 1 mm", bent > 1e-4 && bent < 1e-3, bent);
