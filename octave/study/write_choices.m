## -*- texinfo -*-
## @deftypefn {} {} write_choices (@var{table}, @var{folder})
## The @var{table} of @code{verify_choices} as choices.csv.
## @end deftypefn

function write_choices (table, folder)
  lines = {"scene and model,kind,true error [tolerances],estimate [tolerances],smaller model [tolerances],as promised"};
  for row = table
    lines{end+1} = sprintf ("\"%s\",%s,%.6g,%.6g,%.6g,%d", strrep (row.name, "\"", "'"), row.kind, row.error, ...
                            row.estimate, row.smaller, row.good);
  endfor
  write_text (fullfile (folder, "choices.csv"), [strjoin(lines, "\n") "\n"]);
endfunction

%!function text = written (folder)
%!  row = struct ("name", "a \"rod\": rigid", "kind", "rod", "error", 0.5, "estimate", 0.25, "smaller", NaN, "good", 1);
%!  write_choices (row, folder);
%!  text = fileread (fullfile (folder, "choices.csv"));
%!endfunction
%!assert (strsplit (in_scratch (@(folder, scratch) written (folder)), "\n"){2}, "\"a 'rod': rigid\",rod,0.5,0.25,NaN,1");
