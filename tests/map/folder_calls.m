## -*- texinfo -*-
## @deftypefn {} {[@var{number}, @var{folders}, @var{pairs}] =} folder_calls (@var{calls})
## @var{number}(i,j) of the @var{calls} (see @code{call_graph}) go from the i-th to the j-th of the @var{folders}
## (cellstr), those within a folder left out; the k-th call is one from folder @var{pairs}(k,1) to @var{pairs}(k,2).
## @end deftypefn

function [number, folders, pairs] = folder_calls (calls)
  paths = [{calls.caller}, {calls.called}];
  [folders, ~, index] = unique (cellfun (@fileparts, paths, "UniformOutput", false));
  pairs = reshape (index, [], 2);
  number = accumarray (pairs, 1, numel (folders)*[1 1]);
  number(logical (eye (numel (folders)))) = 0;
endfunction

%!test
%! calls = struct ("caller", {"run/f.m"; "run/f.m"; "rod/h.m"; "rod/h.m"}, ...
%!                 "called", {"rod/g.m"; "rod/h.m"; "rod/g.m"; "run/k.m"});
%! [number, folders, pairs] = folder_calls (calls);
%! assert (folders, {"rod", "run"});
%! assert (number, [0 1; 2 0]);
%! assert (pairs, [2 1; 2 1; 1 1; 1 2]);
