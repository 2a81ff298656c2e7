## -*- texinfo -*-
## @deftypefn {} {} say (@var{template}, @dots{})
## Print a line for a person, arguments as for @code{printf}, unless the environment has QUIET. On a terminal what
## begins with "warning:" is coloured, unless the environment has NO_COLOR.
## @end deftypefn

function say (template, varargin)
  if (is_set ("QUIET"))
    return;
  endif
  show_progress ("");
  text = sprintf (template, varargin{:});
  if (strncmp (text, "warning:", 8) && on_terminal () && ! is_set ("NO_COLOR"))
    text = ["\033[33mwarning:\033[0m" text(9:end)];
  endif
  printf ("%s\n", text);
endfunction

function set = is_set (name)
  set = ! any (strcmp (getenv (name), {"", "0"}));
endfunction

%!test
%! unwind_protect
%!   setenv ("QUIET", "");
%!   assert (evalc ("say ('warning: %d', 3)"), "warning: 3\n");
%!   setenv ("QUIET", "1");
%!   assert (evalc ("say ('warning: %d', 3)"), "");
%! unwind_protect_cleanup
%!   setenv ("QUIET", "");
%! end_unwind_protect
%!test # what the progress has left on the line goes first
%! stand_in = {"show_progress", "text", "printf (\"<%s>\", text);"};
%! assert (evalc ("with_stand_ins (stand_in, @() say ('%d rods', 3));"), "<>3 rods\n");
%!test # so do all studies: QUIET=1 leaves none of their tables
%! folder = fileparts (which ("statics"));
%! texts = cellfun (@fileread, glob (fullfile (folder, "*.m")), "uniformoutput", false);
%! printed = regexp (strjoin (texts, "\n"), '^ *f?(?:printf|puts|disp) \((?!stderr)', "match", "lineanchors");
%! assert (printed, cell (1, 0));
