## -*- texinfo -*-
## @deftypefn {} {[@var{columns}, @var{values}] =} read_points (@var{file})
## A table of points: CSV with a header of names (see @code{read_columns}) and a row a point (see @code{read_value}).
## A row of more or fewer cells than the header has, and one that stands twice, is an error with its line.
## @end deftypefn

function [columns, values] = read_points (file)
  [id, message] = fopen (file, "r");
  if (id < 0 || isfolder (file))
    scene_error ("OVER: %s cannot be read: %s", file, message);
  endif
  text = strtrim (fread (id, [1 Inf], "uint8=>char"));
  fclose (id);
  byte_order_mark = char ([0xEF 0xBB 0xBF]);
  lines = ostrsplit (strrep (strrep (text, byte_order_mark, ""), "\r", ""), "\n");
  [~, name, extension] = fileparts (file);
  name = [name extension];
  if (isempty (lines))
    scene_error ("%s is empty: it takes a header of names and a row a point", name);
  endif
  columns = read_columns (ostrsplit (lines{1}, ","), name);
  values = cell (numel (lines) - 1, numel (columns));
  if (isempty (values))
    scene_error ("%s has a header and no points", name);
  endif
  for k = 2:numel (lines)
    cells = ostrsplit (lines{k}, ",");
    if (numel (cells) != numel (columns))
      scene_error ("%s, line %d has %d cells where the header has %d", name, k, numel (cells), numel (columns));
    endif
    for j = 1:numel (columns)
      values{k-1,j} = read_value (cells{j}, sprintf ("%s, line %d, %s", name, k, columns{j}));
    endfor
  endfor
  refuse_repeated (columns, values, name);
endfunction

function refuse_repeated (columns, values, name)
  words = cellfun (@(row) point_words (columns, row), num2cell (values, 2), "uniformoutput", false);
  [again, before] = first_repeated (words);
  if (! isempty (again))
    scene_error ("%s, line %d has the point of line %d: %s", name, again + 1, before + 1, words{again});
  endif
endfunction

%!function [columns, values] = read (text)
%!  [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%!  write_text (file, text);
%!  [columns, values] = read_points (file);
%!endfunction
%!test # as a spreadsheet writes it, too
%! for text = {"a.b,c\n1,x\n2,0 4\n", [char([239 187 191]) "a.b,c\r\n1,x\r\n2,0 4\r\n\r\n"]}
%!   [columns, values] = read (text{1});
%!   assert (columns, {"a.b", "c"}); assert (values, {1, "x"; 2, [0 4]});
%! endfor
%!test # what is no number or word is refused with its line, and so is what is not there
%! for row = {"1,=1+2", "1,../x", "1,\"2\"", "1, ", "1", "1,2,3", ""}
%!   fail ("read (strjoin ({'a,b', '1,2', row{1}, '3,4'}, \"\\n\"))", "line 3(, b is|  *has \\d cells where)");
%! endfor
%!error <a, line 4 has the point of line 2: a=1; b=0.5> read ("a,b\n1,0.5\n1,2\n1.0,5e-1\n")
%!error <a is empty: it takes a header of names and a row a point> read ("")
%!error <a is empty: it takes a header of names and a row a point> read (" \n\n")
%!error <has a header and no points> read ("a,b\n")
%!error <: a stands there twice> read ("a,a\n1,1\n")
%!error <OVER: /nowhere/x.csv cannot be read: .> read_points ("/nowhere/x.csv")
