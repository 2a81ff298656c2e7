## -*- texinfo -*-
## @deftypefn {} {@var{mathml} =} mathml_scripts (@var{base}, @var{below}, @var{above})
## The MathML @var{base} with what stands @var{below} and @var{above} it (MathML, or empty): scripts beside it, of a
## sum limits under and over it.
## @end deftypefn

function mathml = mathml_scripts (base, below, above)
  mathml = base;
  scripts = {below, above};
  filled = ! cellfun (@isempty, scripts);
  if (any (filled))
    kinds = {"msub", "msup", "msubsup"};
    if (strcmp (base, "<mo>∑</mo>"))
      kinds = {"munder", "mover", "munderover"};
    endif
    kind = kinds{filled*[1; 2]};
    mathml = ["<" kind ">" base scripts{filled} "</" kind ">"];
  endif
endfunction

%!assert (mathml_scripts ("a", "", ""), "a")
%!assert (mathml_scripts ("a", "i", ""), "<msub>ai</msub>")
%!assert (mathml_scripts ("a", "", "n"), "<msup>an</msup>")
%!assert (mathml_scripts ("a", "i", "n"), "<msubsup>ain</msubsup>")
%!test # limits of a sum
%! assert (tex_to_mathml ("\\sum_k"), ["<math displaystyle=\"true\"><mrow><munder><mo>∑</mo><mi>k</mi></munder>" ...
%!                                     "</mrow></math>"]);
%! assert (mathml_scripts ("<mo>∑</mo>", "", "n"), "<mover><mo>∑</mo>n</mover>");
%! assert (mathml_scripts ("<mo>∑</mo>", "k", "n"), "<munderover><mo>∑</mo>kn</munderover>");
