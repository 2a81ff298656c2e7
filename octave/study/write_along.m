## -*- texinfo -*-
## @deftypefn {} {} write_along (@var{along}, @var{folder})
## What the sections of rods bear (see @code{section_columns}) as along.csv: rows as those of shape.csv, body after
## body.  A cell is empty where its number is not known.
## @end deftypefn

function write_along (along, folder)
  [names, units] = section_columns (along);
  heads = cellfun (@(name, unit) sprintf ("%s [%s]", name, unit), names, units, "uniformoutput", false);
  table = zeros (0, 2 + numel (names));
  for k = 1:numel (along)
    values = cell2mat (cellfun (@(name) along{k}.(name), names, "uniformoutput", false));
    part = linspace (0, 1, rows (values)).';
    table = [table; repmat(k, rows (values), 1), part, values];
  endfor
  cells = num2cell (table);
  cells(isnan (table)) = {""};
  write_csv (fullfile (folder, "along.csv"), [{"body", "part of the length"}, heads], cells);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! body = struct ("N", [1; 2], "stress", [3; 4]);
%! write_along ({body, setfield(body, "stress", [NaN; NaN])}, folder);
%! assert (fileread (fullfile (folder, "along.csv")), ...
%!         "body,part of the length,N [N],stress [Pa]\n1,0,1,3\n1,1,2,4\n2,0,1,\n2,1,2,\n");
