## -*- texinfo -*-
## @deftypefn {} {@var{states} =} keep (@var{states}, @var{k}, @var{y})
## The @var{states} (see @code{first_states}) with the state @var{y} in column @var{k}.
## @end deftypefn

function states = keep (states, k, y)
  for name = {"q", "v", "lambda", "W", "D"}
    states.(name{1})(:,k) = y.(name{1});
  endfor
endfunction

%!assert (keep (struct ("q", 0, "v", 0, "lambda", 0, "W", 0, "D", 0), 2, ...
%!              struct ("q", 1, "v", 2, "lambda", 3, "W", 4, "D", 5)).D, [0 5])
