## The size checks and the help text of a generated function.  octave check_sizes.m FOLDER

1;

function check (name, passed)
  if (passed)
    printf ("ok %s\n", name);
  else
    printf ("not ok %s: it is not so\n", name);
  endif
endfunction

function check_message (arguments_given, wanted, f = @every_shape)
  message = "no error";
  try
    f (arguments_given{:});
  catch problem
    message = problem.message;
  end_try_catch
  check (["message " wanted], strncmp (message, wanted, length (wanted)));
endfunction

function list = replace (list, k, value)
  list{k} = value;
endfunction

addpath (argv (){end});
V = [1; 2];
M = [2, 1; 1, 3];
good = {[1, 2, 3], [4, 5, 6], 1, 2, V, V, M, [1; 2; 3], 0.5};

[field, constant, quotient, image, rotation] = every_shape (good{:});
check ("sizes of results", isequal (size (field), [1, 3]) && isequal (constant, [1, 1, 1]) && isscalar (quotient)
       && isequal (size (image), [2, 1]) && isequal (rotation, [1, 1; -2, 3]));
[~, constant] = every_shape (replace (good, 1, 7){:});
check ("a scalar beside an array", isequal (constant, [1, 1, 1]));
[~, constant] = every_shape (replace (replace (good, 1, 7), 2, 8){:});
check ("scalars for arrays", isequal (constant, 1));

check_message (replace (good, 2, [4, 5]), "every_shape: y must be 1-by-3, not 1-by-2");
check_message (replace (good, 2, [4; 5; 6]), "every_shape: y must be 1-by-3, not 3-by-1");
check_message (replace (good, 4, []), "every_shape: a_b_ must be 1-by-1, not 0-by-0");
check_message (replace (good, 5, [1, 2]), "every_shape: V must be 1-by-1, not 1-by-2");
check_message (replace (good, 6, [1; 2; 3]), "every_shape: W must be 2-by-1, not 3-by-1");
check_message (replace (good, 6, ones (2, 1, 2)), "every_shape: W must be 2-by-1, not 2-by-1-by-2");
check_message (replace (good, 7, [1, 2]), "every_shape: M must be 2-by-2, not 1-by-2");
check_message (replace (good, 8, [1, 2, 3]), "every_shape: sin_ must be 3-by-1, not 1-by-3");
check_message (good(1:8), "Invalid call to every_shape");

rod = struct ("mass_matrix", M, "end", 3, "sin", [1; 2; 3], "not asked for", 4);
good = {rod, 2, struct("V", V), struct("x", [1, 2], "y", 7)};
[energy, elementwise] = structures (good{:});
check ("fields of structs", energy == V.'*M*V && isequal (elementwise, sin ([1, 2]) + 3*2*7));
check_message (replace (good, 1, setfield (rod, "sin", 1)), ...
               "structures: rod.sin must be 3-by-1, not 1-by-1", @structures);
check_message (replace (good, 3, struct ("V", 1)), "structures: motion.V must be 2-by-1, not 1-by-1", @structures);
check_message (good(1:3), "Invalid call to structures", @structures);

[text, format] = get_help_text ("every_shape");
check ("help is Texinfo", strcmp (format, "texinfo") && ! isempty (strfind (text, "@{braces@} and an @@")));
