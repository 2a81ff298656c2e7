## -*- texinfo -*-
## @deftypefn {} {@var{system} =} led_on_surface (@var{system}, @var{run})
## The @var{system} of a rod on a surface (see @code{surface_rod}) with the motion of a @var{run} of the same scene, by
## as many base functions or others, as a first guess of its own: led_states (t), places and velocities (2n-by-k) at
## the times t (1-by-k, s).
## @end deftypefn

function system = led_on_surface (system, run)
  if (! isfield (run, "between"))
    return;
  endif
  model = run.model;
  [known, at] = ismember (coefficient_names (system.numbers), coefficient_names (model.numbers));
  onto = system.place.basis \ eye (numel (known))(:,known);
  q = (model.place.basis*run.between.states(1:model.n,:) + model.place.start)(at(known),:);
  q_dot = (model.place.basis*run.between.states(model.n+1:2*model.n,:))(at(known),:);
  z = onto*q - system.place.basis \ system.place.start;
  path = spline (run.between.t, [z; onto*q_dot]);
  system.led_states = @(t) ppval (path, t);
endfunction

%!function varargout = looked_at (seen, residual, varargin)
%!  seen("evaluations") += 1;
%!  [varargout{1:nargout}] = residual (varargin{:});
%!endfunction
%!function [run, evaluations] = run_of (kind, scene, model, varargin)
%!  seen = containers.Map ("evaluations", 0);
%!  kind.system = @(scene, model) setfield (model, "residual", @(varargin) looked_at (seen, model.residual, varargin{:}));
%!  run = run_model (kind, scene, model, varargin{:});
%!  evaluations = seen("evaluations");
%!endfunction
%!test # by the same model again, many steps at once; by fewer polynomials, and led astray, it arrives, too
%! kind = surface_kind ();
%! scene = check_surface_scene (setfield (large_swing (), "duration", 0.31));
%! solver = setfield (scene.solver, "tolerance", 7e-4);
%! [few, more] = deal (kind.build (scene, [6 6]), kind.build (scene, [8 8]));
%! [alone, evaluations] = run_of (kind, scene, more, solver);
%! [led, fewer] = run_of (kind, scene, more, solver, alone);
%! assert (fewer < 0.4*evaluations);
%! assert (distance (led, alone) < 1e-4);
%! by_few = run_model (kind, scene, few, solver);
%! astray = by_few;
%! astray.between.states(1,:) += 0.1*sin (50*astray.between.t);
%! for name = {"gauss", "radau"}
%!   solver.name = name{1};
%!   alone = run_model (kind, scene, more, solver);
%!   assert (distance (run_model (kind, scene, more, solver, by_few), alone) < 1e-4);
%!   assert (distance (run_model (kind, scene, more, solver, astray), alone) < 1e-4);
%! endfor
%!test # without states between the frames nothing leads
%! assert (led_on_surface (struct ("n", 2), struct ("history", [])), struct ("n", 2));
