## -*- texinfo -*-
## @deftypefn {} {[@var{calls}, @var{files}] =} call_graph (@var{root}, @var{more})
## The calls among the function files under octave/ in the folder @var{root} (default: the project), within these, and
## those of files of generated/ there.  @var{calls} (n-by-1) has the fields caller and called (paths from @var{root}),
## within and name (the functions there), line (text) and arguments (texts with \v between, "@@" of a handle).
## @var{files} (cellstr) are those under octave/.  Calls of files in the folders @var{more} (a text) are there, too.
## @end deftypefn

function [calls, files] = call_graph (root = fileparts (fileparts (which ("driver"))), more = "")
  reader = fullfile (fileparts (mfilename ("fullpath")), "calls.awk");
  go = sprintf ("cd %s && ", shell_string (root));
  [~, text] = system ([go "find octave -name '*.m' | LC_ALL=C sort"]);
  files = strsplit (strtrim (text), "\n");
  [status, text] = system ([go "LC_ALL=C.UTF-8 gawk -f " shell_string(reader) ...
                            " $(find octave generated " more " -name '*.m' | LC_ALL=C sort)"]);
  if (status != 0)
    error ("the calls cannot be read: %s", strtrim (text));
  endif
  names = {"caller", "within", "line", "called", "name", "arguments"};
  calls = cell2struct (reshape (ostrsplit (text, "\t\n")(1:end-1), numel (names), []), names, 1);
endfunction

%!function text = calls_of (varargin)
%!  ## the calls in a file of these lines: function, line, name, arguments
%!  [root, gone] = scratch_folder ();
%!  mkdir (fullfile (root, "generated")); mkdir (fullfile (root, "octave"));
%!  write_text (fullfile (root, "generated", "law.m"), "");
%!  write_text (fullfile (root, "octave", "rod.m"), strjoin (varargin, "\n"));
%!  for name = {"arc", "bar", "cog"}
%!    write_text (fullfile (root, "octave", [name{1} ".m"]), "");
%!  endfor
%!  calls = call_graph (root);
%!  lines = arrayfun (@(c) sprintf ("%s %s %s(%s)", c.within, c.line, c.name, strrep (c.arguments, "\v", "|")), ...
%!                    calls, "UniformOutput", false);
%!  text = strjoin (lines(:).', "; ");
%!endfunction
%!test # what is a call
%! assert (calls_of ("function y = rod (x, z = bar (2))", "  y = law (x, [arc(1), 2])' + x.cog (3) + numbar (4);", ...
%!                   "  f = {@cog, @(t) law(t, ...", "                     \")\")};", "endfunction"), ...
%!         "rod 1 bar(2); rod 2 law(x| [arc(1), 2]); rod 2 arc(1); rod 3 cog(@); rod 3 law(t| \")\")");
%!test # what is none
%! assert (calls_of ("# bar (1)", "function rod (arc)", "  bar.x(2) = arc (1) == bar (1); # bar (1)", ...
%!                   "  [cog, y{1}] = f (\"law (\\\" 1)\", 'law (1)', x', cog (3));", "endfunction", ...
%!                   "function bars ()", "  bar (1);", "endfunction", "%!test bar (1)"), "bars 7 bar(1)");
%!test # variables and functions of the file
%! assert (calls_of ("function rod ()", "  for arc = 1:2", "    bar(1) += arc (2);", "  endfor", ...
%!                   "  cellfun (@(law) law (1), {cog(1)})", "endfunction", "function cog (x)", "endfunction"), ...
%!         "rod 5 cog(1)");
%!test # without parentheses
%! assert (calls_of ("function rod ()", "  [x.cog, y] = bar;", "  cog on", "endfunction"), "rod 2 bar(); rod 3 cog()");
%!assert (calls_of ("bar (arc () {:});"), " 1 bar(arc () {:});  1 arc()")
%!test # the program calls nothing that only its tests have
%! calls = call_graph (fileparts (fileparts (which ("driver"))), "tests/samples tests/octave tests/choices tests/pairs");
%! strange = strncmp ({calls.caller}, "octave/", 7) & strncmp ({calls.called}, "tests/", 6);
%! assert (strjoin (strcat ({calls(strange).caller}, {" calls "}, {calls(strange).name}), "\n"), "");
