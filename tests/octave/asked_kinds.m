## -*- texinfo -*-
## @deftypefn {} {@var{found} =} asked_kinds (@var{text})
## Lines of the @var{text} of an Octave file (a cell array) that ask of which kind a scene is, or whether its rod is
## curved.  What differs between kinds stands in octave/kinds/.
## @end deftypefn

function found = asked_kinds (text)
  lines = strsplit (text, "\n");
  asks = 'isfield \((?!drawing).*"(bodies|surface)"|\<rod\.curvature\>(?!")';
  found = strtrim (lines(cellfun (@isempty, regexp (lines, '^ *(%!|#)', "once")) ...
                         & ! cellfun (@isempty, regexp (lines, asks, "once"))));
endfunction

%!test
%! asked = {"if (isfield (scene, \"bodies\"))", "if (isempty (scene.rod.curvature))", ...
%!          "x = isfield (a(1), {\"surface\"});"};
%! assert (asked_kinds (strjoin ([asked, {"# rod.curvature", "y.curvature", "%! isfield (a, \"bodies\")", ...
%!                                        "\"rod.curvature\", []", "isfield (drawing, \"surface\")"}], "\n")), asked);
%!test # only the kinds know, and what is about a rod's axis
%! octave = fileparts (which ("driver"));
%! [~, files] = system (["cd '" octave "' && find . -name '*.m' -not -path './kinds/*' -not -path './rod/*'"]);
%! lines = {};
%! for file = strsplit (strtrim (files), "\n")
%!   lines = [lines, strcat(file{1}, {": "}, asked_kinds (fileread (fullfile (octave, file{1}))))];
%! endfor
%! assert (strjoin (lines, "\n"), "");
