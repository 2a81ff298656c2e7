## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} left_out_of_body (@var{reference}, @var{rung}, @var{part}, @var{open})
## What a @var{rung} of a mechanism leaves out of the motion of a @var{reference}, a trial (m): of the @var{part}, one
## kind of modes of one body (see @code{mechanism_ladder} and @code{left_out}).  Inf where the constraints would depend
## on each other at the start, with no more modes than the rung has of the bodies that are @var{open} (1-by-bodies).
## @end deftypefn

function metres = left_out_of_body (reference, rung, part, open)
  models = reference.model.models;
  k = part.body;
  order = struct ("longitudinal", 1, "bending", 2).(part.kind);
  metres = left_out (models{k}, reference.history.bodies(k).V, order, rung.(part.kind)(k));
  of_rung = true (1, reference.model.n);
  for k = find (open)
    base = models{k}.base;
    of_rung(index_of (reference.model, k)(1:end-3)) = [has(base.longitudinal, rung.longitudinal(k)), ...
                                                       has(base.transversal, rung.bending(k))];
  endfor
  if (! independent (reference.start_jacobian(:,of_rung)))
    metres = Inf;
  endif
endfunction

## as many functions, and with any of them the corrections for the ends, whose numbers are below 0
function yes = has (numbers, count)
  yes = numbers <= count & count > 0;
endfunction

function yes = independent (jacobian)
  [~, R, ~] = qr (full (jacobian.'), 0);
  sizes = abs (diag (R));
  yes = sum (sizes > 1e-10*max ([sizes; 0])) == rows (jacobian);
endfunction

%!test # pinned at both ends: a second sine of 0.01 m; without what stretches it the constraints depend on each other
%! rod = struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1);
%! scene.bodies = {struct("rod", rod, "model", struct ("modes", "auto"))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", 1, "stations", 1, "point", [1 0])};
%! scene.duration = 1;
%! scene = check_mechanism (scene);
%! rung = @(bending, longitudinal) struct ("bending", bending, "longitudinal", longitudinal);
%! reference.model = mechanism_kind ().build (scene, rung (2, 1));
%! none = zeros (reference.model.n, 1);
%! system = mechanism_system (scene, reference.model);
%! [~, reference.start_jacobian] = system.matrices (system.at (0, none, none));
%! reference.history.bodies.V = [0; 0; 0.02; 0.01];  # of stretching two functions, of bending two sines
%! bending = struct ("kind", "bending", "body", 1);
%! assert (left_out_of_body (reference, rung (1, 1), bending, true), 0.01, 1e-4);
%! assert (left_out_of_body (reference, rung (2, 1), bending, true), 0);
%! assert (left_out_of_body (reference, rung (1, 0), bending, true), Inf);
%! assert (left_out_of_body (reference, rung (1, 0), bending, false), 0.01, 1e-4);
