## -*- texinfo -*-
## @deftypefn {} {} write_summary (@var{summary}, @var{file})
## The struct as JSON, a field a line.
## @end deftypefn

function write_summary (summary, file)
  lines = {};
  for [value, name] = summary
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
