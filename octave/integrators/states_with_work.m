## -*- texinfo -*-
## @deftypefn {} {@var{states} =} states_with_work (@var{method}, @var{h}, @var{states}, @var{work}, @var{power})
## The @var{states} where steps of @var{h} (s) of a collocation @var{method} (see @code{collocation}) start, and the end,
## below them the work of the loads and what is dissipated there: @var{work} (rows-by-1) at first, and then what the
## @var{power} (rows-by-s a step, W) at the stages adds.
## @end deftypefn

function states = states_with_work (method, h, states, work, power)
  steps = columns (states) - 1;
  states = [states; work + [zeros(rows (power), 1), h*cumsum(power*kron (eye (steps), method.weights.'), 2)]];
endfunction

%!assert (states_with_work (struct ("weights", [1 3]), 0.1, [7 8 9], [1; 2], [1 2 3 4; 0 0 1 1]), [7 8 9; 1 1.7 3.2; 2 2 2.4], 1e-12)
