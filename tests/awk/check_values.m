## The translated rows of values.tsv at their arguments, to 2e-14.  octave check_values.m VALUES FOLDER
## FOLDER has the function value_K for row K of VALUES, its comment counted.

1;

function list = arguments_of (text)
  x = y = a = b = c = o = sin_ = x_y = x_y_ = end_ = beta = p = E = 1;
  V = W = S = Q = [1; 1];
  M = eye (2);
  u = [1; 1; 1];
  R = ones (2, 3);
  eval ([text ";"]);
  list = {x, y, a, b, c, V, W, M, u, o, R, x_y, x_y_, sin_, end_, beta, S, Q, p, E};
endfunction

format long
addpath (argv (){end});
rows_of_table = strsplit (strtrim (fileread (argv (){end-1})), "\n");
for k = 2:numel (rows_of_table)
  row = strsplit (rows_of_table{k}, "\t");
  wanted = eval (row{4});
  try
    got = feval (sprintf ("value_%d", k), arguments_of (row{2}){:});
  catch problem
    got = problem.message;
  end_try_catch
  if (size_equal (got, wanted) && all ((abs (got - wanted) <= 2e-14 * abs (wanted))(:)))
    printf ("ok value %s at %s\n", row{[3, 2]});
  else
    printf ("not ok value %s at %s: got %s, not %s\n", row{[3, 2]}, strtrim (disp (got)), mat2str (wanted, 17));
  endif
endfor
