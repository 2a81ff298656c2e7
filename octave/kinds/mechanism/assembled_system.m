## -*- texinfo -*-
## @deftypefn {} {@var{system} =} assembled_system (@var{scene}, @var{mechanism})
## The system of a checked scene's @var{mechanism} (see @code{mechanism_system}), put together (see
## @code{assemble_mechanism}), or in equilibrium where its start is to be that: with initial_state, state_scale (see
## @code{integrate}) and the warnings of its assembly.
## @end deftypefn

function system = assembled_system (scene, mechanism)
  system = mechanism_system (scene, mechanism);
  [start, system.warnings] = assemble_mechanism (scene, mechanism, system);
  if (strcmp (scene.initial.from, "equilibrium"))
    start.q = equilibrium (mechanism_at_rest (scene, mechanism), 0);
    start.v = project_velocities (system, 0, start.q, 0*start.v);
  endif
  system.initial_state = stacked_rows (start);
  system.state_scale = system.q_scale;
  system.energy_rows = [];
endfunction

%!test
%! [~, ~, scene] = sample_mechanism ([0 1]);
%! mechanism = build_mechanism (scene, mechanism_rungs (scene, [0 0 0]));
%! system = assembled_system (scene, mechanism);
%! [start, warnings] = assemble_mechanism (scene, mechanism, system);
%! assert (named_rows (system, system.initial_state).q, start.q); assert (system.warnings, warnings);
