## -*- texinfo -*-
## @deftypefn {} {@var{mathml} =} tex_to_mathml (@var{tex})
## A formula in the TeX that Maxima writes (groups, \over, ^, _, \left, \right, accents, functions, names of letters)
## as MathML, inline with fractions as large as in display. A command that is not known is an error, which names it.
## @end deftypefn

function mathml = tex_to_mathml (tex)
  tokens = regexp (tex, '\\[A-Za-z]+|\\.|[0-9]+(\.[0-9]+)?|[A-Za-z]|[^\sA-Za-z0-9]', "match");
  [mathml, rest] = row_of (tokens);
  if (! isempty (rest))
    error ("tex_to_mathml: \"%s\" has no beginning", rest{1});
  endif
  ## a sign that a broken formula goes on with
  mathml = regexprep (mathml, '^<mrow><mo stretchy="false">([+=]|−)', '<mrow><mo stretchy="false" form="infix">$1');
  mathml = ["<math displaystyle=\"true\">" mathml "</math>"];
endfunction

## everything up to the end of a group or a pair of parentheses
function [mathml, rest] = row_of (rest)
  parts = {};
  over = [];
  while (! isempty (rest) && ! any (strcmp (rest{1}, {"}", "\\right"})))
    if (strcmp (rest{1}, "\\over"))
      over = row (parts);
      parts = {};
      rest = rest(2:end);
    else
      [parts{end+1}, rest] = scripted (rest);
    endif
  endwhile
  mathml = row (parts);
  if (! isempty (over))
    mathml = ["<mfrac>" over mathml "</mfrac>"];
  endif
endfunction

## an atom with what stands below and above it: a prime is above
function [mathml, rest] = scripted (rest)
  mathml = "<mrow></mrow>";
  if (! any (strcmp (rest{1}, {"^", "_"})))
    [mathml, rest] = atom_of (rest);
  endif
  scripts = {"", ""};  # below and above
  while (! isempty (rest) && any (strcmp (rest{1}, {"^", "_", "'"})))
    mark = rest{1};
    rest(1) = [];
    script = "<mo>′</mo>";
    if (! strcmp (mark, "'"))
      [script, rest] = atom_of (rest);
    endif
    if (strcmp (mark, "_"))
      scripts{1} = [scripts{1}, script];
    else
      scripts{2} = [scripts{2}, script];
    endif
  endwhile
  mathml = mathml_scripts (mathml, scripts{:});
endfunction

function mathml = row (parts)
  mathml = ["<mrow>" parts{:} "</mrow>"];
endfunction

function [mathml, rest] = atom_of (rest)
  persistent accents = struct ("dot", "˙", "ddot", "¨", "bar", "¯");
  persistent functions = {"sin", "cos", "tan", "arctan"};
  token = rest{1};
  rest(1) = [];
  name = regexprep (token, '^\\', "");
  mathml = mathml_sign (token);
  if (ischar (mathml))
    return;
  elseif (strcmp (token, "{"))
    [mathml, rest] = row_of (rest);
    rest(1) = [];
  elseif (isfield (accents, name) && token(1) == "\\")
    [base, rest] = atom_of (rest);
    mathml = ["<mover accent=\"true\">" base "<mo>" accents.(name) "</mo></mover>"];
  elseif (any (strcmp (name, {"mathbf", "mathrm"})) && token(1) == "\\")
    [base, rest] = atom_of (rest);
    letters = regexprep (base, '<[^>]*>', "");
    if (strcmp (name, "mathbf") && numel (letters) == 1)
      ## Browsers know no other bold than the letters of their own: U+1D400 is A, U+1D41A is a.
      letters = char ([240, 157, 144, 128 + lower(letters) - "a" + 26*islower(letters)]);
    endif
    mathml = ["<mi mathvariant=\"normal\">" letters "</mi>"];
  elseif (any (strcmp (name, {"rm", "it"})) && token(1) == "\\")
    last = find (strcmp ([rest, {"}"}], "}"), 1) - 1;
    mathml = ["<mi>" strrep([rest{1:last}], "\\_", "_") "</mi>"];
    rest(1:last) = [];
  elseif (strcmp (token, "\\sqrt"))
    [inner, rest] = atom_of (rest);
    mathml = ["<msqrt>" inner "</msqrt>"];
  elseif (strcmp (token, "\\left"))
    first = rest{1};
    [inner, rest] = row_of (rest(2:end));
    mathml = ["<mrow><mo>" first "</mo>" inner "<mo>" rest{2} "</mo></mrow>"];
    rest(1:2) = [];
  elseif (any (strcmp (name, functions)) && token(1) == "\\")
    applied = "<mo>&#8289;</mo><mspace width=\"0.17em\"/>";
    mathml = ["<mi>" name "</mi>" applied];
    ## sin ^2 x: the exponent belongs to the function's name
    if (! isempty (rest) && strcmp (rest{1}, "^"))
      [script, rest] = atom_of (rest(2:end));
      mathml = ["<msup><mi>" name "</mi>" script "</msup>" applied];
    endif
  elseif (! isempty (regexp (token, '^\d')))
    mathml = ["<mn>" token "</mn>"];
  elseif (isletter (token(1)))
    mathml = ["<mi>" token "</mi>"];
  elseif (token(1) != "\\")
    mathml = ["<mo stretchy=\"false\">" strrep(html_escape (token), "-", "−") "</mo>"];
  else
    error ("tex_to_mathml: \"%s\" is not known", token);
  endif
endfunction

%!test
%! text = tex_to_mathml ("{{\\mathbf{V}\\cdot a^2}\\over{2}}-\\dot{\\varphi}");
%! expected = ["<math displaystyle=\"true\"><mrow><mfrac><mrow><mrow><mi mathvariant=\"normal\">𝐕</mi><mo>·</mo>" ...
%!             "<msup><mi>a</mi><mn>2</mn></msup></mrow></mrow><mrow><mrow><mn>2</mn></mrow></mrow></mfrac>" ...
%!             "<mo stretchy=\"false\">−</mo><mover accent=\"true\"><mrow><mi>φ</mi></mrow><mo>˙</mo></mover>" ...
%!             "</mrow></math>"];
%! assert (text, expected);
%!test # functions
%! assert (! isempty (strfind (tex_to_mathml ("\\sin ^2\\varphi"), "<msup><mi>sin</mi><mn>2</mn></msup>")));
%! assert (! isempty (strfind (tex_to_mathml ("{\\rm atan2}(x)"), "<mi>atan2</mi>")));
%!test # parentheses are one thing
%! assert (! isempty (strfind (tex_to_mathml ("\\left(a\\right)^2"), "<mo>)</mo></mrow><mn>2</mn></msup>")));
%!test # scripts stand above each other, and a prime with them
%! assert (! isempty (strfind (tex_to_mathml ("^2"), "<msup><mrow></mrow><mn>2</mn></msup>")));
%! assert (! isempty (strfind (tex_to_mathml ("M'_j"), "<msubsup><mi>M</mi><mi>j</mi><mo>′</mo></msubsup>")));
%!test # roots and names of several letters
%! assert (! isempty (strfind (tex_to_mathml ("\\sqrt{a}"), "<msqrt><mrow><mi>a</mi></mrow></msqrt>")));
%! assert (! isempty (strfind (tex_to_mathml ("{\\it half\\_angle}^2"), "<mi>half_angle</mi>")));
%!test # nothing is lost of what is derived: its letters, numbers and signs are those of the MathML
%! letters = @(text) sort (regexp (text, '[A-Za-z0-9+=(),-]', "match"));
%! plain = @(tex) regexprep (tex, '\\(?!sin|cos)[A-Za-z]+|\\[,!;]', "");
%! files = glob (fullfile (fileparts (which ("rod_equations")), "equations_*.tex"));
%! assert (numel (files) >= 12);
%! for formula = regexp (strjoin (cellfun (@fileread, files.', "UniformOutput", false), ""), '[^\n]+', "match")
%!   if (formula{1}(1) != "\\" || isempty (regexp (formula{1}, '^\\(section|par)', "once")))
%!     tex = strrep (formula{1}, "\\mathbf{", "{");
%!     text = strrep (regexprep (tex_to_mathml (tex), '<[^>]*>|&#\d+;', ""), "−", "-");
%!     assert (letters (text), letters (plain (tex)));
%!   endif
%! endfor
%!error <"\\foo" is not known> tex_to_mathml ("\\foo")
