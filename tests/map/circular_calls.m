## -*- texinfo -*-
## @deftypefn {} {@var{against} =} circular_calls (@var{calls})
## Those of the @var{calls} (see @code{call_graph}) without which folders do not call each other in a circle, a line
## each (cellstr): of the pairs of folders that stand in one, that whose calls, if they went, would leave the fewest
## calls in circles, and so on until there is none.
## @end deftypefn

function against = circular_calls (calls)
  [number, ~, pairs] = folder_calls (calls);
  against = {};
  while (any (in_circles (number)(:)))
    worst = worst_pair (number);
    number(worst) = 0;
    for call = calls(sub2ind (size (number), pairs(:,1), pairs(:,2)) == worst).'
      against{end+1} = [call.caller ":" call.line " calls " call.called];
    endfor
  endwhile
endfunction

## pairs (i, j) from where calls come back to i
function yes = in_circles (number)
  reached = number > 0;
  for k = 1:rows (number)
    reached |= reached(:,k) & reached(k,:);
  endfor
  yes = number > 0 & reached.';
endfunction

## the pair that holds most circles together, and of such that of the fewest calls
function worst = worst_pair (number)
  table = zeros (0, 3);
  for pair = find (in_circles (number)).'
    without = number;
    without(pair) = 0;
    table(end+1,:) = [sum(without(in_circles (without))), number(pair), pair];
  endfor
  worst = sortrows (table)(1,3);
endfunction

%!function text = against (varargin)
%!  ## of calls between folders, "from to"
%!  call = @(pair) struct ("caller", [pair{1} "/f.m"], "line", "1", "called", [pair{2} "/f.m"]);
%!  text = strjoin (circular_calls (cellfun (call, regexp (varargin, '\w+', "match").')), ", ");
%!endfunction
%!assert (against ("run rod", "run say", "rod say", "rod rod"), "")
%!assert (against ("run rod", "rod run", "run rod"), "rod/f.m:1 calls run/f.m")
%!assert (against ("run rod", "rod say", "rod say", "run say", "say run", "say files"), "say/f.m:1 calls run/f.m")
%!assert (against ("a b", "b a", "a b", "c d", "c d", "d e", "e c", "e c"), "d/f.m:1 calls e/f.m, b/f.m:1 calls a/f.m")
%!assert (strjoin (circular_calls (call_graph ()), "\n"), "")
