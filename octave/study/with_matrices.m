## -*- texinfo -*-
## @deftypefn {} {@var{model} =} with_matrices (@var{model}, @var{found}, @var{into}, @var{hold}, @var{by})
## The matrices of a linear @var{model} (see @code{linear_model}) about the equilibrium @var{found} (see
## @code{at_rest}): inputs, of which some are driven, put @var{into} forces (n-by-m), and @var{hold} (n-by-m)
## coordinates where they are prescribed; outputs change @var{by}.q, v, lambda and u.
##
## With q = Z y + S d, d what is prescribed: Z'M (Z y'' + S d'') + Z'C (Z y' + S d') + Z'K (Z y + S d) = Z'F u.
## @end deftypefn

function model = with_matrices (model, found, into, hold, by)
  linear = found.linear;
  Z = linear.basis;
  driven = model.driven;
  S = hold(:,driven);
  damping = found.balance.damping (found.time, found.q, found.lambda);
  [p, d, m] = deal (columns (Z), sum (driven), columns (into));
  loads = eye (m)(:,! driven);
  drives = eye (m)(:,driven);
  place = [Z, zeros(rows (Z), p), S, zeros(rows (Z), d)];  # q by the states y, y', d, d'
  rate = [zeros(rows (Z), p), Z, zeros(rows (Z), d), S];
  held = [zeros(m, 2*p), drives, zeros(m, d)];  # inputs by the states
  left = into*held - linear.stiffness*place - damping*rate;  # forces without inertia, by the states
  pushed = into*loads*loads.' - linear.mass*S*drives.';  # and by the inputs
  scale = 1./sqrt (diag (linear.M)(:));  # polynomials of strains weigh by powers of ten
  y = scale.*((scale.*linear.M.*scale.') \ (scale.*(Z.'*[left, pushed])));
  [y_x, y_u] = deal (y(:,1:columns (left)), y(:,columns (left)+1:end));
  model.M = linear.M;
  model.C = (linear.C + linear.C.')/2;
  model.G = (linear.C - linear.C.')/2;
  model.K = linear.K;
  model.F = Z.'*into*loads*loads.';
  model.basis = Z;
  model.A = [zeros(p), eye(p), zeros(p, 2*d); y_x; zeros(d, 2*p + d), eye(d); zeros(d, 2*(p + d))];
  model.B = [zeros(p, m); y_u; zeros(d, m); drives.'];
  of_forces = inverse_of (linear.jacobian).';
  lambda_x = of_forces*(left - linear.mass*Z*y_x);
  lambda_u = of_forces*(pushed - linear.mass*Z*y_u);
  model.C_out = by.q*place + by.v*rate + by.lambda*lambda_x + by.u*held;
  model.D = by.lambda*lambda_u + by.u*loads*loads.';
endfunction

%!test # two masses on springs of which the second is driven: m y'' + k y = k d
%! model = struct ("driven", [false true]);
%! found.linear = struct ("M", 2, "C", 0, "K", 5, "basis", [1; 0], "stiffness", [5 -3; -3 3], "mass", diag ([2 1]), ...
%!                        "jacobian", [0 1]);
%! found.balance.damping = @(t, q, lambda) zeros (2);
%! [found.time, found.q, found.lambda] = deal (0, [0; 0], 0);
%! by = struct ("q", [1 0], "v", [0 0], "lambda", 0, "u", [0 0]);
%! model = with_matrices (model, found, [1 0; 0 0], [0 0; 0 1], by);
%! assert (model.A, [0 1 0 0; -5/2 0 3/2 0; 0 0 0 1; 0 0 0 0]); assert (model.B, [0 0; 1/2 0; 0 0; 0 1]);
%! assert ({model.F, model.C_out, model.D}, {[1 0], [1 0 0 0], [0 0]});
%! assert (model.basis, found.linear.basis);
%!test # what is held altogether has no states but those of what is prescribed: q = d, u = 3 d
%! model = struct ("driven", true);
%! found.linear = struct ("M", [], "C", [], "K", [], "basis", zeros (1, 0), "stiffness", 3, "mass", 2, "jacobian", 1);
%! found.balance.damping = @(t, q, lambda) 0;
%! [found.time, found.q, found.lambda] = deal (0, 0, 0);
%! model = with_matrices (model, found, 0, 1, struct ("q", 1, "v", 0, "lambda", 0, "u", 3));
%! assert (model.A, [0 1; 0 0]); assert (model.B, [0; 1]); assert (model.C_out, [4 0]);
