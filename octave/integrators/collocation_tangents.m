## -*- texinfo -*-
## @deftypefn {} {@var{tangents} =} collocation_tangents (@var{system}, @var{method}, @var{t}, @var{h}, @var{stages}, @
##   @var{a})
## Linear about the @var{stages} (see @code{collocation_stages}) of steps of @var{h} (s) of a collocation @var{method}
## at the times @var{t}: a struct of M, C and K (n-by-n, a page a stage) of the @var{system}, h, and factors, those of
## each step's Newton matrix (lower, upper and order).
##
## Every stage has its own stiffness in Newton's matrix: what stretches turns with the rod within a step, and is stiff.
## @end deftypefn

function tangents = collocation_tangents (system, method, t, h, stages, a)
  tangents.h = h;
  tangents.K = system.tangent_stiffness (t, stages{:}, a);
  tangents.M = system.mass_matrix (stages{1});
  tangents.C = 0*tangents.K;
  if (system.damped)
    tangents.C = system.tangent_damping (t, stages{:}, a);
  endif
  s = numel (method.points);
  for i = 1:columns (a)/s
    pages = s*(i - 1) + (1:s);
    matrix = newton_matrix (method, h, tangents, pages, system.damped);
    [factors.lower, factors.upper, factors.order] = lu (matrix, "vector");
    tangents.factors(i) = factors;
  endfor
endfunction

function matrix = newton_matrix (method, h, tangents, pages, damped)
  n = rows (tangents.K);
  for i = 1:numel (pages)
    own = (i - 1)*n + (1:n);
    matrix(own,:) = kron (h^2*method.AA(i,:), tangents.K(:,:,pages(i)));
    if (damped)
      matrix(own,:) += kron (h*method.A(i,:), tangents.C(:,:,pages(i)));
    endif
    matrix(own,own) += tangents.M(:,:,pages(i));
  endfor
endfunction

%!test # two steps of two stages, with damping: M a + C (h A a) + K (h^2 AA a) in each
%! pages = @(values) reshape (values, 1, 1, []);
%! system = struct ("damped", true, "tangent_stiffness", @(varargin) pages ([1 2 3 4]), ...
%!                  "tangent_damping", @(varargin) pages ([5 6 7 8]), "mass_matrix", @(z) pages ([9 10 11 12]));
%! method = collocation (2);
%! tangents = collocation_tangents (system, method, 1:4, 0.5, {1:4, 1:4}, 1:4);
%! for i = 1:2
%!   own = 2*i - [1 0];
%!   matrix = diag (8 + own) + 0.5*diag (4 + own)*method.A + 0.25*diag (own)*method.AA;
%!   f = tangents.factors(i);
%!   assert (f.lower*f.upper, matrix(f.order,:), 1e-12);
%! endfor
%! assert (tangents.h, 0.5); assert (size (tangents.K), [1 1 4]);
