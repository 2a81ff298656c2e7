## -*- texinfo -*-
## @deftypefn {} {@var{found} =} idioms (@var{text})
## Lines of the tests in the @var{text} of an Octave file (a cell array) that pass whatever comes out: bounds of max (),
## which passes over NaN, and of all (), which holds for nothing; `! (a < b)' holds for NaN; a text after two numbers is
## a tolerance, the codes of its letters.  assert takes arrays: assert (abs (x) < 1e-9) holds if it does for each value,
## and for no empty one.
## @end deftypefn

function found = idioms (text)
  lines = regexp (text, '^%!.*$', "match", "lineanchors", "dotexceptnewline");
  blind = {'assert \(max \([^&]*<', 'assert \(all \(', '! \(.*[<>]', ...
           'assert \(.*, [0-9]+, [a-z]+\{1\}\)'};
  holds = false (size (lines));
  for pattern = blind
    holds |= ! cellfun (@isempty, regexp (lines, pattern{1}, "once"));
  endfor
  found = lines(holds);
endfunction

%!test
%! line = @(claim) ["%! " sprintf("assert (%s);", claim)];
%! lines = cellfun (line, {"max (abs (x)) < 1e-9", "abs (x) < 1e-9", "! (x > 1)", "x(max (y)) == 1", "all (x)", ...
%!                         "n, 1, part{1}"}, "uniformoutput", false);
%! assert (idioms (strjoin ([lines, {"  y = ! (x > 1);"}], "\n")), lines([1 3 5 6]));
%!test # no test of the project has one
%! root = fileparts (fileparts (fileparts (which ("idioms"))));
%! [~, files] = system (sprintf ("find '%s/octave' '%s/tests' -name '*.m'", root, root));
%! files = setdiff (strsplit (strtrim (files), "\n"), {which("idioms")});
%! assert (numel (files) > 300);
%! for file = files
%!   assert (strjoin (idioms (fileread (file{1})), "\n"), "");
%! endfor
