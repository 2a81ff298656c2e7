## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{power}] =} states_with_work (@var{system}, @var{method}, @var{t}, @var{h}, @
##   @var{states}, @var{work}, @var{stages}, @var{a})
## The @var{states} where steps of @var{h} (s) from the time @var{t} on of a collocation @var{method} (see
## @code{collocation}) start, and the end, below them the work of the loads and what is dissipated there: @var{work}
## (rows-by-1) at first, and then what the @var{power} (rows-by-s a step, W) of the @var{system} at the stages adds.
## @var{stages} and @var{a} are of @code{collocation_stages}.
## @end deftypefn

function [states, power] = states_with_work (system, method, t, h, states, work, stages, a)
  steps = columns (states) - 1;
  power = system.power (t + h*((0:steps-1) + method.points)(:).', stages{:}, a);
  states = [states; work + [zeros(rows (power), 1), h*cumsum(power*kron (eye (steps), method.weights.'), 2)]];
endfunction

%!test # two steps from t = 5 on
%! system.power = @(t, z, v, a) [t + z; v + a];
%! method = struct ("points", [0.5; 1], "weights", [1 3]);
%! [states, power] = states_with_work (system, method, 5, 0.1, [7 8 9], [1; 2], {1:4, [0 0 1 1]}, [2 0 0 0]);
%! assert (power, [6.05 7.1 8.15 9.2; 2 0 1 1], 1e-12);
%! assert (states, [7 8 9; 1, 1 + 2.735, 1 + 2.735 + 3.575; 2 2.2 2.6], 1e-12);
