## -*- texinfo -*-
## @deftypefn {} {} write_csv (@var{file}, @var{heads}, @var{table}, @var{quoted})
## A @var{table}, a matrix or a cell array of numbers and texts, as CSV under its @var{heads} (a cellstr, one a column):
## numbers with 17 significant digits, texts in quotes where they have a comma, a quote or a line's end in them, those
## in the columns @var{quoted} (by default none) always.
## @end deftypefn

function write_csv (file, heads, table, quoted = [])
  template = ["%s" repmat(",%s", 1, numel (heads) - 1) "\n"];
  heads = cellfun (@csv_cell, heads, "uniformoutput", false);
  text = sprintf (template, heads{:});
  if (iscell (table))
    always = repmat ({false}, size (table));
    always(:,quoted) = {true};
    table = cellfun (@csv_cell, table, always, "uniformoutput", false).';
    template = repmat (template, 1, columns (table));
    text = [text, sprintf(template, table{:})];
  elseif (! isempty (table))
    text = [text, sprintf(strrep (template, "%s", "%.17g"), table.')];
  endif
  write_text (file, text);
endfunction

function text = csv_cell (value, quoted = false)
  if (! ischar (value))
    text = sprintf ("%.17g", value);
  elseif (quoted || any (ismember (value, ",\"\n")))
    text = ["\"" strrep(value, "\"", "\"\"") "\""];
  else
    text = value;
  endif
endfunction

%!function text = written (varargin)
%!  [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%!  write_csv (file, varargin{:});
%!  text = fileread (file);
%!endfunction
%!test
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! write_csv (file, {"t [s]", "V2_1 [m]"}, [0 pi; 0.1 2]);
%! assert (strncmp (fileread (file), "t [s],V2_1 [m]\n", 15));
%! assert (csvread (file, 1, 0), [0 pi; 0.1 2]);
%!assert (written ({"a", "b, c"}, {0.1, "x"; true, ""; 7, "a \"b\""}), ...
%!        "a,\"b, c\"\n0.10000000000000001,x\n1,\n7,\"a \"\"b\"\"\"\n")
%!assert (written ({"a", "b"}, {"x", "y"; "", "\"y\""}, 2), "a,b\nx,\"y\"\n,\"\"\"y\"\"\"\n")
%!assert (written ({"a", "b"}, zeros (0, 2)), "a,b\n") # no rows
%!assert (written ({"a", "b"}, cell (0, 2)), "a,b\n")
