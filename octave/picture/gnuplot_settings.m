## -*- texinfo -*-
## @deftypefn {} {@var{text} =} gnuplot_settings (@var{settings})
## The fields of the struct @var{settings} as variables of gnuplot: texts, numbers, and arrays of the texts or numbers
## of a cell array (gnuplot has none without elements: it gets a 0 then); a field of two numbers, a range, gives the
## variables @var{name}_low and @var{name}_high.
## @end deftypefn

function text = gnuplot_settings (settings)
  text = "";
  for [value, name] = settings
    if (iscell (value))
      if (isempty (value))
        value = {0};
      endif
      elements = strjoin (cellfun (@literal, value(:).', "UniformOutput", false), ", ");
      text = [text, sprintf("array %s[%d] = [%s]\n", name, numel (value), elements)];
    elseif (isnumeric (value) && ! isscalar (value))
      text = [text, sprintf("%s_low = %s\n%s_high = %s\n", name, literal (value(1)), name, literal (value(2)))];
    else
      text = [text, sprintf("%s = %s\n", name, literal (value))];
    endif
  endfor
endfunction

function text = literal (value)
  if (ischar (value))
    text = gnuplot_string (value);
  else
    text = sprintf ("%.12g", value);
  endif
endfunction

%!test
%! text = gnuplot_settings (struct ("title", "a", "now", 0.5, "x", [1 2]));
%! assert (text, "title = 'a'\nnow = 0.5\nx_low = 1\nx_high = 2\n");
%!test # gnuplot reads arrays back, also texts with blanks and quotes, and numbers that are no number of strtod's
%! names = {"it's \"a b\"", "", "c, d [2]"};
%! text = gnuplot_settings (struct ("names", {names}, "sizes", {{1, 1e-320, -1e300}}, "none", {{}}));
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! write_text (file, [text "set print '-'; print names[1].'|'.names[2].'|'.names[3]; print sizes[2] > 0, |none|"]);
%! [~, said] = system (["gnuplot " file]);
%! assert (said, "it's \"a b\"||c, d [2]\n1 1\n");
