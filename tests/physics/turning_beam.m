## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} turning_beam (@var{spin}, @var{n}, @var{hold}, @var{radius})
## In-plane frequencies of an inextensible Euler-Bernoulli beam that turns at the @var{spin}, clamped or hinged
## ("hinge") as @var{hold} says at the @var{radius} of a hub (default 0), the first @var{n}, by the power series of its
## equation (Wright, Smith, Thresher and Wang 1982): w'''' - (T w')' - spin^2 w = omega^2 w, T = spin^2 ((1 - x^2)/2 +
## radius (1 - x)), on a unit length with E I = rho A = 1.  A hinged one's first is its swing in the hub, 0 without
## radius.
## @end deftypefn

function omega = turning_beam (spin, n, hold, radius = 0)
  ends = @(omega) end_determinant (omega.^2 + spin^2, spin, hold, radius);
  grid = linspace (0.05, 4.5*n^2*pi^2, 200*n + 1);
  values = ends (grid);
  omega = zeros (1, strcmp (hold, "hinge") && radius == 0);
  for k = find (values(1:end-1).*values(2:end) < 0)(1:n-numel (omega))
    omega(end+1) = fzero (ends, grid([k k+1]), optimset ("TolX", 1e-12));
  endfor
endfunction

## of bending moment and shear force at the free end, by the squares of the frequency and the spin together (1-by-k)
function value = end_determinant (square, spin, hold, radius)
  start = 2*strcmp (hold, "clamped") + strcmp (hold, "hinge");
  moment = shear = {};
  for power = [start, 3]  # of x, which are free
    a = zeros (60, numel (square));  # of x^0, x^1, ...
    a(power+1,:) = 1;
    slope = @(a, j) (j + 1)*a(max (j + 2, 1),:)*(j >= 0);  # of w'
    for k = 0:55
      flux = (k + 1)*((1/2 + radius)*slope (a, k + 1) - radius*slope (a, k) - slope (a, k - 1)/2);
      a(k+5,:) = (spin^2*flux + square.*a(k+1,:))/((k + 4)*(k + 3)*(k + 2)*(k + 1));
    endfor
    k = 0:59;
    moment{end+1} = (k.*(k - 1))*a;
    shear{end+1} = (k.*(k - 1).*(k - 2))*a;
  endfor
  value = moment{1}.*shear{2} - moment{2}.*shear{1};
endfunction

%!test # at rest: clamped 1.8751041, 4.6940911, 7.8547574; hinged 3.9266023, 7.0685827
%! assert (turning_beam (0, 3, "clamped"), [1.87510407 4.69409113 7.85475744].^2, 1e-6);
%! assert (turning_beam (0, 3, "hinge"), [0, [3.92660231 7.06858275].^2], 1e-6);
%!test # and as collocation has it
%! assert (turning_beam (7, 3, "hinge")(2:3).', rotating_beam (7, 2), -1e-4);
%!test # flapping frequencies squared are larger by the spin's square: some of Wright's table of 1982
%! for row = [1 3.6817 22.1810 61.8418; 6 7.3604 26.8091 66.6839; 12 13.1702 37.6031 79.6145].'
%!   assert (sqrt (turning_beam (row(1), 3, "clamped").^2 + row(1)^2), row(2:4).', 6e-5);
%! endfor
%!test # a rigid rod swings in a hub at spin*sqrt (3/2 radius)
%! assert (turning_beam (1e-2, 1, "hinge", 40), 1e-2*sqrt (60), 1e-4);
