## Call the translated records and compare with Maxima's values: 1e-12 relative and 1e-14 of the arguments, and in
## sensitive expressions a thousand times what rounding to 16 digits does in Maxima. Few may be that sensitive.
##   octave compare.m FOLDER SEED

1;

function results = call_record (name, count, x, y, scalars)
  u = [5; -7; 13] / 8;
  R = [3/4, -1/2, 5/4; 1/8, 7/4, -3/8];
  V = [3/2; 5/8; 9/8];
  W = [7/8; 1/2; 11/8];
  M = [5/4, -1/4, 1/2; 3/8, 9/8, -1/8; -3/4, 1/4, 7/8];
  results = cell (1, count);
  [results{:}] = feval (name, x, y, num2cell (scalars){:}, u, R, V, W, M);
endfunction

function list = by_rows (value)
  list = double (value.'(:).');
endfunction

arguments_given = argv ();
folder = arguments_given{end-1};
seed = arguments_given{end};
addpath (folder);
values = strsplit (fileread (fullfile (folder, "values")), "\n");
shapes = textscan (fileread (fullfile (folder, "shapes")), "%d %s");
expressions = strsplit (fileread (fullfile (folder, "expressions.mac")), "\n");
expressions = expressions(strncmp (expressions, "expression", 10));
failures = sensitive = number = 0;

for record = 1:max (shapes{1})
  name = sprintf ("batch_%d", record);
  count = sum (shapes{1} == record);
  first = call_record (name, count, [3; -7; 13] / 8, [3; 5; -1] / 8, [-5/8, 11/8, 3/4, 7/4, 1/2, -3/8, 2]);
  second = call_record (name, count, 9/8, [9, -3] / 8, [11/8, 11/8, -1/4, 5/8, 9/8, 3/2, 1]);
  wrong = 0;
  for k = 1:count
    number++;
    got = [by_rows(first{k}), by_rows(second{k})];
    numbers = sscanf (values{number}, "%f").';
    wanted = numbers(1:2:end);
    tolerance = 1e-12 * abs (wanted) + 1e-14 + 1e3 * numbers(2:2:end);
    sensitive += any (tolerance > 1e-9 * max (abs (wanted), 1e-4));
    if (! size_equal (got, wanted) || ! all (abs (got - wanted) <= tolerance))
      wrong++;
      printf ("not ok seed %s expression %d: %s\n  got    %s\n  wanted %s\n", seed, number, expressions{number},
              mat2str (got), mat2str (wanted));
    endif
  endfor
  failures += wrong;
  if (! wrong)
    printf ("ok record %d, %d expressions\n", record, count);
  endif
endfor

if (sensitive > number / 100)
  printf ("not ok sensitivity: %d of %d expressions say little about the translator\n", sensitive, number);
else
  printf ("ok sensitivity, %d of %d expressions lenient\n", sensitive, number);
endif
exit (failures > 0 || sensitive > number / 100);
