## -*- texinfo -*-
## @deftypefn {} {@var{quoted} =} shell_string (@var{text})
## @var{text} as one word of a shell command.
## @end deftypefn

function quoted = shell_string (text)
  quoted = ["'" strrep(text, "'", "'\\''") "'"];
endfunction

%!test
%! text = "it's \"$HOME\" `x` \\ *";
%! [~, said] = system (["printf %s " shell_string(text)]);
%! assert (said, text);
