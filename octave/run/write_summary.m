## -*- texinfo -*-
## @deftypefn {} {} write_summary (@var{summary}, @var{file})
## The struct as JSON, a field a line.  The loads, with their breaks, and the models tried are lists, also of one.
## @end deftypefn

function write_summary (summary, file)
  lines = {};
  if (isfield (summary, "loads") && isstruct (summary.loads))
    summary.loads = arrayfun (@(load) setfield (load, "breaks", num2cell (load.breaks)), summary.loads);
  endif
  for [value, name] = summary
    if (any (strcmp (name, {"loads", "tried"})) && isstruct (value))
      value = num2cell (value);  # jsonencode makes an object of a single struct
    endif
    if (isempty (value) && ! ischar (value))
      value = [];  # jsonencode writes nothing at all for an empty struct array
    endif
    lines{end+1} = sprintf ("  \"%s\": %s", name, jsonencode (value));
  endfor
  write_text (file, ["{\n" strjoin(lines, ",\n") "\n}\n"]);
endfunction

%!test
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! summary = struct ("title", "a \"rod\"", "modes", [0 7], "none", [], "warnings", {{}});
%! summary.tried = struct ("name", {});
%! write_summary (summary, file);
%! assert (jsondecode (fileread (file)).modes, [0; 7]);
%! assert (jsondecode (fileread (file)).title, "a \"rod\"");
%!function text = written (name, value)
%!  [folder, gone] = scratch_folder ();
%!  write_summary (struct (name, {value}), fullfile (folder, "a"));
%!  text = strsplit (fileread (fullfile (folder, "a")), "\n"){2};
%!endfunction
%!test # lists are lists, however many they have
%! load = @(breaks) struct ("name", "moment", "looked_at", 20011, "breaks", breaks);
%! one = @(breaks) sprintf ("{\"name\":\"moment\",\"looked_at\":20011,\"breaks\":[%s]}", breaks);
%! assert (written ("loads", load (zeros (1, 0))(zeros (1, 0))), "  \"loads\": []");
%! assert (written ("loads", load (zeros (1, 0))), ["  \"loads\": [" one("") "]"]);
%! assert (written ("loads", [load(0.5), load([1 2])]), ["  \"loads\": [" one("0.5") "," one("1,2") "]"]);
%! assert (written ("tried", struct ("name", "rigid")), "  \"tried\": [{\"name\":\"rigid\"}]");
%! assert (written ("seconds", struct ("choice", 0)), "  \"seconds\": {\"choice\":0}");
