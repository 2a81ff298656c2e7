## -*- texinfo -*-
## @deftypefn {} {@var{mathml} =} tex_to_mathml (@var{tex})
## A formula in the TeX that Maxima writes (groups, \over, ^, _, \left, \right, accents, functions, names of letters) as
## MathML. A command that is not known is an error, which names it.
## @end deftypefn

function mathml = tex_to_mathml (tex)
  tokens = regexp (tex, '\\[A-Za-z]+|\\.|[0-9]+(\.[0-9]+)?|[A-Za-z]|[^\sA-Za-z0-9]', "match");
  [mathml, rest] = row_of (tokens);
  if (! isempty (rest))
    error ("tex_to_mathml: \"%s\" has no beginning", rest{1});
  endif
  mathml = ["<math display=\"block\">" mathml "</math>"];
endfunction

## everything up to the end of a group or a pair of parentheses
function [mathml, rest] = row_of (rest)
  parts = {};
  over = [];
  while (! isempty (rest) && ! any (strcmp (rest{1}, {"}", "\\right"})))
    if (strcmp (rest{1}, "\\over"))
      [over, parts, rest] = deal (row (parts), {}, rest(2:end));
    elseif (any (strcmp (rest{1}, {"^", "_"})))
      kind = {"msub", "msup"}{1 + strcmp(rest{1}, "^")};
      [script, rest] = atom_of (rest(2:end));
      if (isempty (parts))
        parts = {"<mrow></mrow>"};
      endif
      parts{end} = ["<" kind ">" parts{end} script "</" kind ">"];
    else
      [parts{end+1}, rest] = atom_of (rest);
    endif
  endwhile
  mathml = row (parts);
  if (! isempty (over))
    mathml = ["<mfrac>" over mathml "</mfrac>"];
  endif
endfunction

function mathml = row (parts)
  mathml = ["<mrow>" parts{:} "</mrow>"];
endfunction

function [mathml, rest] = atom_of (rest)
  persistent symbols = struct ("varphi", "φ", "lambda", "λ", "mu", "μ", "rho", "ρ", "tau", "τ", "xi", "ξ", "sigma", "σ", ...
                               "pi", "π", "psi", "ψ", "theta", "θ", "alpha", "α", "beta", "β", "bullet", "•");
  persistent accents = struct ("dot", "˙", "ddot", "¨");
  persistent functions = {"sin", "cos", "tan", "arctan", "sqrt"};
  token = rest{1};
  rest(1) = [];
  name = regexprep (token, '^\\', "");
  if (strcmp (token, "{"))
    [mathml, rest] = row_of (rest);
    rest(1) = [];
  elseif (isfield (accents, name))
    [base, rest] = atom_of (rest);
    mathml = ["<mover accent=\"true\">" base "<mo>" accents.(name) "</mo></mover>"];
  elseif (any (strcmp (name, {"mathbf", "mathrm"})))
    [base, rest] = atom_of (rest);
    letters = regexprep (base, '<[^>]*>', "");
    if (strcmp (name, "mathbf") && numel (letters) == 1)
      ## Browsers know no other bold than the letters of their own: U+1D400 is A, U+1D41A is a.
      letters = char ([240, 157, 144, 128 + lower(letters) - "a" + 26*islower(letters)]);
    endif
    mathml = ["<mi mathvariant=\"normal\">" letters "</mi>"];
  elseif (strcmp (name, "rm"))
    letters = find (cellfun (@(t) isempty (regexp (t, '^[A-Za-z0-9]+$')), [rest, {"}"}]), 1) - 1;
    mathml = ["<mi>" rest{1:letters} "</mi>"];
    rest(1:letters) = [];
  elseif (strcmp (name, "left"))
    first = rest{1};
    [inner, rest] = row_of (rest(2:end));
    mathml = ["<mrow><mo>" first "</mo>" inner "<mo>" rest{2} "</mo></mrow>"];
    rest(1:2) = [];
  elseif (strcmp (token, "\\cdot"))
    mathml = "<mo>·</mo>";
  elseif (isfield (symbols, name) && token(1) == "\\")
    mathml = ["<mi>" symbols.(name) "</mi>"];
  elseif (any (strcmp (name, functions)) && token(1) == "\\")
    applied = "<mo>&#8289;</mo><mspace width=\"0.17em\"/>";
    mathml = ["<mi>" name "</mi>" applied];
    ## sin ^2 x: the exponent belongs to the function's name
    if (! isempty (rest) && strcmp (rest{1}, "^"))
      [script, rest] = atom_of (rest(2:end));
      mathml = ["<msup><mi>" name "</mi>" script "</msup>" applied];
    endif
  elseif (any (strcmp (token, {"\\,", "\\!"})))
    mathml = "";
  elseif (strcmp (token, "\\;"))
    mathml = "<mspace width=\"0.3em\"/>";
  elseif (! isempty (regexp (token, '^\d')))
    mathml = ["<mn>" token "</mn>"];
  elseif (isletter (token(1)) || token(1) == "'")
    mathml = ["<mi>" strrep(token, "'", "′") "</mi>"];
  elseif (token(1) != "\\")
    mathml = ["<mo stretchy=\"false\">" strrep(html_escape (token), "-", "−") "</mo>"];
  else
    error ("tex_to_mathml: \"%s\" is not known", token);
  endif
endfunction

%!test
%! text = tex_to_mathml ("{{\\mathbf{V}\\cdot a^2}\\over{2}}-\\dot{\\varphi}");
%! expected = ["<math display=\"block\"><mrow><mfrac><mrow><mrow><mi mathvariant=\"normal\">𝐕</mi><mo>·</mo>" ...
%!             "<msup><mi>a</mi><mn>2</mn></msup></mrow></mrow><mrow><mrow><mn>2</mn></mrow></mrow></mfrac>" ...
%!             "<mo stretchy=\"false\">−</mo><mover accent=\"true\"><mrow><mi>φ</mi></mrow><mo>˙</mo></mover></mrow></math>"];
%! assert (text, expected);
%!test # functions
%! assert (! isempty (strfind (tex_to_mathml ("\\sin ^2\\varphi"), "<msup><mi>sin</mi><mn>2</mn></msup>")));
%! assert (! isempty (strfind (tex_to_mathml ("{\\rm atan2}(x)"), "<mi>atan2</mi>")));
%!test # parentheses are one thing
%! assert (! isempty (strfind (tex_to_mathml ("\\left(a\\right)^2"), "<mo>)</mo></mrow><mn>2</mn></msup>")));
%!error <"\\foo" is not known> tex_to_mathml ("\\foo")
