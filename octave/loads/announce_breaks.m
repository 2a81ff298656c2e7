## -*- texinfo -*-
## @deftypefn {} {} announce_breaks (@var{probed})
## Say in one line at which times the loads of a scene jump, or begin or end to change, that the scene does not state
## (@var{probed} comes from @code{load_breaks}), and which loads were looked at less often than usual.
## @end deftypefn

function announce_breaks (probed)
  parts = {};
  for load = probed
    if (! isempty (load.breaks))
      parts{end+1} = sprintf ("%s at t = %s s", load.name, times_text (load.breaks));
    endif
    if (load.looked_at < 4000)
      parts{end+1} = sprintf ("%s takes long, it was looked at %d times only", load.name, load.looked_at);
    endif
  endfor
  if (! isempty (parts))
    say ("breaks found in the loads: %s", strjoin (parts, "; "));
  endif
endfunction

function text = times_text (times)
  text = strjoin (arrayfun (@(t) sprintf ("%.6g", t), times(1:min (end, 6)), "UniformOutput", false), ", ");
  if (numel (times) > 6)
    text = sprintf ("%s and %d more", text, numel (times) - 6);
  endif
endfunction

%!test
%! said = evalc ("announce_breaks (struct ('name', 'moment', 'looked_at', 20011, 'breaks', [12.3 12.35]))");
%! assert (strtrim (said), "breaks found in the loads: moment at t = 12.3, 12.35 s");
%! assert (evalc ("announce_breaks (struct ('name', 'moment', 'looked_at', 20011, 'breaks', zeros (1, 0)))"), "");
%! said = evalc ("announce_breaks (struct ('name', 'force', 'looked_at', 1009, 'breaks', 1:9))");
%! assert (strtrim (said), ["breaks found in the loads: force at t = 1, 2, 3, 4, 5, 6 and 3 more s; force takes" ...
%!                          " long, it was looked at 1009 times only"]);
%! said = evalc ("announce_breaks (struct ('name', 'force', 'looked_at', 20011, 'breaks', 1:6))");
%! assert (strtrim (said), "breaks found in the loads: force at t = 1, 2, 3, 4, 5, 6 s");
