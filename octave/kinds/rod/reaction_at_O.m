## -*- texinfo -*-
## @deftypefn {} {[@var{reaction_x}, @var{reaction_y}] =} reaction_at_O (@var{t}, @var{motion}, @var{q_ddot}, @
##   @var{phi_ddot}, @var{c})
## The force (1-by-m, N) with which the hinge or hub at O holds a rod at the times @var{t} (1-by-m), by
## @code{rod_reaction}: a rigid rod that hangs at rest has (0, m g), one that turns steadily without weight m l/2
## phi_dot^2 towards O.  @var{motion} is a struct of q, q_dot, phi, phi_dot, which have the accelerations @var{q_ddot}
## (n-by-m) and @var{phi_ddot}; @var{c} comes from @code{rod_constants}.
##
## It is as exact as the accelerations are: a place that is off by d in a mode with the stiffness k makes it off by
## some k d.
## @end deftypefn

function [reaction_x, reaction_y] = reaction_at_O (t, motion, q_ddot, phi_ddot, c)
  motion = struct ("V", motion.q, "V_dot", motion.q_dot, "V_ddot", q_ddot, "phi", motion.phi, ...
                   "phi_dot", motion.phi_dot, "phi_ddot", phi_ddot);
  [reaction_x, reaction_y] = rod_reaction (motion, c.rod, c.point, c.gravity, force_at (t, c));
  if (! isempty (c.joined))
    pull = pull_of_joints (t, motion, c.joined);
    reaction_x -= pull.x;
    reaction_y -= pull.y;
  endif
endfunction

%!function [R, history] = held (scene, varargin)
%!  history = driver (scene, "output", "", varargin{:}).history;
%!  R = [history.reaction_x; history.reaction_y];
%!endfunction
%!test # a rigid rod that swings: its weight and centrifugal load along it, and a quarter of its weight across it
%! scene = setfield (setfield (paper (), "moment", 0), "moment_breaks", []);
%! scene.model = struct ("modes", [0 0], "rotary_inertia", false); scene.duration = 0.5;
%! [R, history] = held (scene, "tolerance", 1e-10);
%! [along, across] = deal ([cos(history.phi); sin(history.phi)], [-sin(history.phi); cos(history.phi)]);
%! m = 7800*6e-4;
%! assert (sum (R.*along, 1), m*9.81*sin (history.phi) - m/2*history.phi_dot.^2, 1e-9*m*9.81);
%! assert (sum (R.*across, 1), m*9.81*cos (history.phi)/4, 1e-9*m*9.81);
%!test # one that hangs at rest with a mass at its tip: both weights, of an elastic one at its middle, too
%! for modes = [0 3]
%!   scene = setfield (setfield (paper (), "moment", 0), "tip_mass", 2); scene.duration = 0.1;
%!   scene.model.modes = [0 modes]; scene.initial.phi = -pi/2;
%!   R = held (scene);
%!   assert (R, [0; 9.81*(7800*6e-4 + 2)]*ones (1, columns (R)), 1e-8);
%! endfor
%!test # in a hub at a steady rate, straight by its symmetry: m l/2 omega^2 towards O, and what is pulled adds its own
%! rod = struct ("length", 2, "EA", 1e5, "EI", 1e3, "rhoA", 3);
%! scene = struct ("rod", rod, "rotation", @(t) [5*t, 5, 0], "gravity", 0, "duration", 1, "frames_per_second", 8);
%! scene.force = @(t) 700*[cos(5*t), sin(5*t)];
%! scene.model = struct ("modes", [0 0], "rotary_inertia", false);
%! [R, history] = held (scene, "tolerance", 1e-6);
%! towards_O = -[cos(history.phi); sin(history.phi)];
%! assert (sum (R.*towards_O, 1), (3*2^2/2*25 + 700)*ones (1, 9), 1e-6);
%! ## rhoA int u dx of the stretched bar, which has no inertia of its own, times omega^2
%! more = 25*3*(3*25*5*2^4/24 + 700*2^2/2)/1e5;
%! scene.model = struct ("modes", "auto", "axial", "quasistatic", "rotary_inertia", false);
%! scene = check_scene (scene);
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "quasistatic", "stiffening", "none");
%! history = run_model (rod_kind (), scene, build_model (scene, rung)).history;
%! R = -history.reaction_x.*cos (history.phi) - history.reaction_y.*sin (history.phi);
%! assert (R - (3*2^2/2*25 + 700), more*ones (1, 9), 1e-3*more);
