## -*- texinfo -*-
## @deftypefn {} {@var{path} =} user_path (@var{text})
## The path of a file or folder that a user calls @var{text}: ~ is home, and a leading dash makes no option of it.
## @end deftypefn

function path = user_path (text)
  path = text;
  if (strncmp (text, "~", 1))
    [user, rest] = strtok (text, "/");
    path = [tilde_expand(user), rest];
  elseif (strncmp (text, "-", 1))
    path = ["./" text];
  endif
endfunction

%!assert (user_path ("~/my rods"), [getenv("HOME") "/my rods"])
%!assert (user_path ("-f"), "./-f")
%!assert (user_path ("a ~/$b"), "a ~/$b")
%!assert (user_path (""), "")
