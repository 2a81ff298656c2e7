## -*- texinfo -*-
## @deftypefn {} {@var{text} =} last_warning ()
## What @code{lastwarn} has, but for warnings that are off: Octave 11 has those of the parser there, from each file that
## it reads for the first time.
## @end deftypefn

function text = last_warning ()
  [text, id] = lastwarn ();
  if (! isempty (id) && strcmp (warning ("query", id).state, "off"))
    text = "";
  endif
endfunction

%!test # one that is on, and one that is off
%! lastwarn ("trouble", "toolchain:trouble");
%! assert (last_warning (), "trouble");
%! lastwarn ("missing semicolon", "Octave:missing-semicolon");
%! assert (last_warning (), "");
%! lastwarn ("");
