## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{amplitude}] =} response_curves (@var{found})
## What @code{frequency_response} has @var{found} as curves: @var{names} (cellstr) and amplitudes, a row a curve.
## @end deftypefn

function [names, amplitude] = response_curves (found)
  names = {};
  for input = found.inputs
    names = [names, strcat(found.outputs(:).', {" by "}, input{1})];
  endfor
  amplitude = reshape (abs (found.response), [], numel (found.f));
endfunction

%!test # two outputs by two inputs
%! found = struct ("f", 1, "response", [1 2; -3 4i], "inputs", {{"a", "b"}}, "outputs", {{"x", "y"}});
%! [names, amplitude] = response_curves (found);
%! assert (names, {"x by a", "y by a", "x by b", "y by b"}); assert (amplitude, [1; 3; 2; 4]);
