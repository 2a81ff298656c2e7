## -*- texinfo -*-
## @deftypefn {} {@var{modes} =} vibrations (@var{linear})
## The natural vibrations of linear equations M y'' + C y' + K y = 0 (see @code{linearised}), from slow to fast: a
## struct of omega (rad/s, of the undamped ones; 1-by-p), damping (the ratio; negative where it grows), rate (1/s: with
## which what is unstable grows, else 0), shape (p-by-p, real, of unit kinetic energy) and vector (p-by-p, likewise,
## but complex where parts of it do not move in phase).
##
## Without damping they are those of the symmetric problem, a follower load or damping takes the eigenvalues of the
## first order system; the slowest have full relative accuracy, inverses are solved.  What is damped so much that it
## creeps back has a ratio above 1.
## @end deftypefn

function modes = vibrations (linear)
  if (isempty (linear.M))
    modes = struct ("omega", zeros (1, 0), "damping", zeros (1, 0), "rate", zeros (1, 0), "shape", [], "vector", []);
    return;
  endif
  M = (linear.M + linear.M.')/2;
  skew = max (max (abs (linear.K - linear.K.')))/max (max (abs (linear.K(:))), realmin);
  if (any (linear.C(:)) || skew > 1e-7)
    modes = complex_modes (M, linear.C, linear.K);
  else
    modes = real_modes (M, both_sides (linear.K));
  endif
  modes.shape ./= sqrt (sum (modes.shape.*(M*modes.shape), 1));
  modes.vector ./= sqrt (real (sum (conj (modes.vector).*(M*modes.vector), 1)));
  [~, order] = sort (modes.omega);
  for name = {"omega", "damping", "rate", "shape", "vector"}
    modes.(name{1}) = modes.(name{1})(:,order);
  endfor
endfunction

## a stiffness that is symmetric up to rounding: what is 0 on one side is rounding on the other
function K = both_sides (K)
  K = ((K + K.')/2).*(K != 0 & K.' != 0);
endfunction

function modes = real_modes (M, K)
  [squares, modes.shape] = undamped_modes (M, K);
  modes.omega = sqrt (max (squares, 0));
  modes.rate = sqrt (max (0, -squares));
  modes.damping = 0*squares;
  modes.vector = modes.shape;
endfunction

## pairs -zeta omega +- i omega sqrt (1 - zeta^2), and what does not oscillate; 1/(s - shift) are the eigenvalues that
## are solved for, in coordinates of like stiffness, so that the slowest have their accuracy beside what is stiff
function modes = complex_modes (M, C, K)
  p = rows (M);
  scale = like_stiffness (M, K);
  [M, C, K] = deal (M.*(scale*scale.'), C.*(scale*scale.'), K.*(scale*scale.'));
  slow = real_modes (M, both_sides (K));
  speeds = max (slow.omega, slow.rate);
  unit = min ([speeds(speeds > noise_of (slow.shape, M, K)), Inf]);
  if (isinf (unit))
    unit = 1;
  endif
  shift = 0.1234567*unit;
  above = -quietly (@() (K + shift*C + shift^2*M) \ [C + shift*M, unit*M]);
  [vectors, values] = eig ([above; (eye(p, 2*p) + shift*above)/unit]);
  values = shift + 1./diag (values).';
  rounding = (1e-9 + 1e-15*abs (values)/unit).*abs (values);
  least = max (noise_of (vectors(1:p,:), M, K), 1e-6*unit);
  pairs = find (imag (values) > rounding + least);
  lone = find (abs (imag (values)) <= rounding + least);
  [~, order] = sort (real (values(lone)), "descend");  # two a mode: the one that grows, or creeps back slower
  kept = [pairs, lone(order(1:p-numel (pairs)))];
  [values, y, rounding, least] = deal (values(kept), vectors(1:p,kept), rounding(kept), least(kept));
  oscillates = 1:p <= numel (pairs);
  noise = rounding + least.*! oscillates;
  modes.omega = abs (values);
  modes.damping = -real (values)./abs (values);
  for k = find (! oscillates)
    [modes.omega(k), modes.damping(k)] = creeping (real (values(k)) < -noise(k), real (y(:,k)), M, C, K);
  endfor
  modes.rate = real (values).*(real (values) > noise);
  modes.vector = scale.*y;
  modes.shape = real (modes.vector./exp (1i*arg (sum (y.*(M*y), 1))/2));
endfunction

## of what comes back, though it does not oscillate: as if nothing damped it, and the ratio, above 1
function [omega, damping] = creeping (comes_back, y, M, C, K)
  omega = damping = 0;
  square = (y.'*K*y)/(y.'*M*y);
  if (comes_back && square > 0)
    omega = sqrt (square);
    damping = (y.'*C*y)/(y.'*M*y)/(2*omega);
  endif
endfunction

%!test # two masses: full accuracy of the slow one beside a stiff spring, and a rigid motion
%! linear = struct ("M", eye (3), "C", zeros (3), "K", diag ([1e14 4 0]));
%! modes = vibrations (linear);
%! assert (modes.omega([1 2]), [0 2], 1e-9); assert (modes.omega(3), 1e7, 1);
%!test # damped by a tenth of the critical: omega stays, the ratio is 0.1; growth of what stands upright
%! modes = vibrations (struct ("M", 2, "C", 2*0.1*2*3, "K", 2*9));
%! assert ([modes.omega, modes.damping, modes.rate], [3 0.1 0], 1e-12);
%! modes = vibrations (struct ("M", 2, "C", 0, "K", -2*9));
%! assert ([modes.omega, modes.damping, modes.rate], [0 0 3], 1e-12);
%!test # a follower load couples two modes: Ziegler's flutter grows
%! linear = struct ("M", [3 1; 1 1], "C", zeros (2), "K", [2 -1; -1 1] - 2.2*[1 -1; 0 0]);
%! modes = vibrations (linear);
%! values = eig ([zeros(2), eye(2); -linear.M\linear.K, zeros(2)]);
%! assert (max (-modes.damping.*modes.omega), max (real (values)), 1e-10);
%! assert (max (modes.rate), max (real (values)), 1e-10); assert (max (modes.rate) > 0.1);
%!test # a rigid motion beside a damped one is one mode, not two
%! modes = vibrations (struct ("M", eye (3), "C", diag ([0 0.6 0]), "K", diag ([0 9 16])));
%! assert (modes.omega, [0 3 4], 1e-9); assert (modes.damping, [0 0.1 0], 1e-9); assert (modes.rate, [0 0 0], 1e-9);
%!test # a disk's two whirls: what moves along x and y a quarter of a period apart; the slow one backwards
%! modes = vibrations (struct ("M", eye (2), "C", [0 1; -1 0], "K", eye (2)));
%! assert (modes.omega, (sqrt (5) + [-1 1])/2, 1e-12);
%! assert (abs (modes.vector(2,:)./modes.vector(1,:) - [1i -1i]) < 1e-12 ...
%!         | abs (modes.vector(2,:)./modes.vector(1,:) + [1i -1i]) < 1e-12);
%! assert (sum (abs (modes.vector).^2), [1 1], 1e-12);
%!test # damped in proportion to a stiffness of ten powers: slow ones oscillate, fast ones creep, each where it would be
%! omega = [1 10 1e3 1e5 1e7];
%! modes = vibrations (struct ("M", eye (5), "C", 1e-4*diag (omega.^2), "K", diag (omega.^2)));
%! assert (modes.omega, omega, -1e-9); assert (modes.damping, 1e-4*omega/2, -1e-6); assert (modes.rate, zeros (1, 5));
%!test # what only a damper holds is not brought back
%! modes = vibrations (struct ("M", eye (2), "C", diag ([3 0.6]), "K", diag ([0 9])));
%! assert (modes.omega, [0 3], 1e-9); assert (modes.damping, [0 0.1], 1e-9);
%!test # rounding on one side of the diagonal does not make what nothing brings back grow
%! modes = vibrations (struct ("M", eye (2), "C", zeros (2), "K", [1e12 0; 1e4 0]));
%! assert (modes.omega, [0 1e6], 1e-3); assert (modes.rate, [0 0]);
