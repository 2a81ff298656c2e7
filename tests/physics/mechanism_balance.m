## -*- texinfo -*-
## @deftypefn {} {[@var{energy}, @var{place}, @var{speed}] =} mechanism_balance (@var{scene}, @var{duration})
## A shipped mechanism's @var{scene} as @code{driver} runs it, with its own settings, for so long (s; its own without):
## how far the @var{energy} balance is off at worst, as a part of what changes, and the largest residual of
## a constraint in @var{place} (m or rad) and in @var{speed} (m/s or rad/s) at any output time.
## @end deftypefn

function [energy, place, speed] = mechanism_balance (scene, duration = [])
  scene = load_scene (scene);
  scene.duration = [duration, scene.duration](1);
  evalc ("summary = driver (scene, 'output', '').summary;");
  [energy, place, speed] = deal (summary.largest_energy_error, summary.largest_constraint_residual, ...
                                 summary.largest_constraint_velocity);
endfunction

%!test # short runs of all of them; without a duration they are the whole ones
%! scenes = {"double_pendulum", 0.15; "chain(8)", 0.5; "chain(20)", 0.5
%!           "slider_crank", 0.004; "four_bar", 0.12; "two_link_arm", 0.1};
%! for scene = scenes.'
%!   [energy, place, speed] = mechanism_balance (scene{:});
%!   assert (energy <= 1e-7); assert (place <= 1e-10); assert (speed <= 1e-8);
%! endfor
