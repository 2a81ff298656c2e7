## -*- texinfo -*-
## @deftypefn {} {} argument_way (@var{name}, @var{argument})
## Print where an @var{argument} of the function @var{name} comes from: each call of it, and below that the calls on
## the shortest way up to the driver, or to what nothing calls.  A line has the text in the argument's place, the next
## one in that of the caller's argument from which this comes, and so on; a line with | assigns what stands there.
## Where it comes from none (in a handle, say), all that is handed over follows.
## @end deftypefn

function argument_way (name, argument)
  calls = call_graph ();
  calls(strcmp ({calls.name}, "driver")) = [];
  found = calls(strcmp (regexprep ({calls.called}, '.*/|\.m$', ""), name) & strcmp ({calls.name}, name));
  if (isempty (found))
    scene_error ("nothing in octave/ calls a function \"%s\"", name);
  endif
  inputs = function_of (found(1).called, name);
  if (! any (strcmp (inputs, argument)))
    scene_error ("%s takes %s: \"%s\" is none of these", name, strjoin (inputs, ", "), argument);
  endif
  for call = found.'
    follow (call, argument, calls, calls_from_driver (calls));
  endfor
endfunction

## so many calls lead from the driver to the caller of each call
function far = calls_from_driver (calls)
  from = strcat ({calls.caller}, ":", {calls.within});
  to = strcat ({calls.called}, ":", {calls.name});
  far = Inf (size (from));
  nearer = strcmp (from, "octave/driver.m:driver");
  for k = 0:numel (calls)
    far(nearer) = k;
    nearer = isinf (far) & ismember (from, to(nearer));
  endfor
endfunction

function follow (call, argument, calls, far)
  indent = "";
  while (! isempty (call))
    texts = strtrim (ostrsplit (call.arguments, "\v"));
    place = find (strcmp (function_of (call.called, call.name), argument));
    printf ("%s%s:%s %s", indent, call.caller, call.line, call.name);
    if (isempty (place) || place > numel (texts) || ! isempty (strfind ([texts{1:place}], "{:}")))
      printf (": %s\n", strjoin (texts, ", "));
      argument = "";
    else
      printf (" (%s): %s\n", argument, texts{place});
      [lines, argument] = origin (call, texts{place});
      cellfun (@(line) printf ("%s| %s\n", indent, line), lines);
    endif
    indent = [indent "  "];
    above = find (strcmp ({calls.called}, call.caller) & strcmp ({calls.name}, call.within));
    [~, nearest] = min (far(above));
    call = calls(above(nearest));
    calls(above(nearest)) = [];  # no way goes in a circle
    far(above(nearest)) = [];
  endwhile
  printf ("\n");
endfunction

## lines of the caller that assign what the text names, and the first argument of the caller there or in these, if any
function [lines, argument] = origin (call, text)
  [inputs, body] = function_of (call.caller, call.within);
  lines = {};
  for name = setdiff (words (text), inputs)
    found = regexp (body, ['^ *(for )?\[?([^=(\n]*, *)?' name{1} '\>[^=\n]*=[^=\n].*$'], "match", ...
                    "lineanchors", "dotexceptnewline");
    lines = [lines, strtrim(found)];
  endfor
  argument = [intersect(inputs, words (strjoin ([lines, {text}])), "stable"), {""}]{1};
endfunction

## names that are no fields and stand not in quotes
function names = words (text)
  names = regexp (text, '(?<![.\w"''])[A-Za-z]\w*', "match");
endfunction

## the names of a function's arguments, and its text from its head on
function [inputs, text] = function_of (file, name)
  text = regexp (fileread (file), ['^function[^\n(]*\<' name '\>.*?^endfunction'], "match", "once", "lineanchors");
  head = regexp (text, '^[^(\n]*\((.*?)\)\n', "tokens", "once");
  inputs = [regexp([", " head{:}], ', *(?:\.\.\.)?\s*(\w+)', "tokens"){:}];
endfunction

%!test # from a generated function to the driver
%! said = strsplit (evalc ("argument_way ('rod_rates', 'motion')"), "\n");
%! assert (regexprep (said{1}, ':\d+', ""), "octave/kinds/rod/hinged_rod_rate.m rod_rates (motion): motion");
%! assert (said{3}, "| motion.phi = y(n+1,:);");
%! assert (regexprep (said{7}, ':\d+', ""), "  octave/kinds/rod/hinged_rod.m hinged_rod_rate (y): y");
%! assert (any (strncmp (strtrim (said), "octave/driver.m:", 16)));
%!error <stays takes q, scale, tolerance: "x" is none of these> argument_way ("stays", "x")
%!error <nothing in octave/ calls a function "nowhere"> argument_way ("nowhere", "x")
%!error id=toolchain:scene argument_way ("nowhere", "x")  # one line
%!error id=toolchain:scene argument_way ("stays", "")
