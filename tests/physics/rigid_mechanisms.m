## -*- texinfo -*-
## @deftypefn {} {@var{off} =} rigid_mechanisms (@var{which})
## Rigid mechanisms against their equations in minimal coordinates, written here independently and integrated by lsode:
## the largest difference of angles (rad) over a second; @var{which} is "double_pendulum" or "slider_crank".
## @end deftypefn

function off = rigid_mechanisms (which)
  times = 0:0.1:1;
  [scene, exact] = feval (which, times);
  scene = check_mechanism (scene);
  mechanism = build_mechanism (scene, mechanism_rungs (scene, [0 0]));
  system = mechanism_system (scene, mechanism);
  start = assemble_mechanism (scene, mechanism, system);
  states = integrate_constrained (system, times, start, struct ("name", "radau", "tolerance", 1e-10));
  angles = [states.q(index_of (mechanism, 1)(1),:); states.q(index_of (mechanism, 2)(1),:)];
  off = max (abs (angles - exact)(:));
endfunction

function scene = two_rods (l_1, l_2)
  rod = @(l) struct ("rod", struct ("length", l, "EA", 1, "EI", 1, "rhoA", 2), "model", struct ("modes", [0 0]));
  scene.bodies = {rod(l_1), rod(l_2)};
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
                  struct("kind", "revolute", "bodies", [1 2], "stations", [l_1 0])};
  scene.duration = 1;
endfunction

function y = solved (rate, start, times)
  lsode_options ("relative tolerance", 1e-13);
  lsode_options ("absolute tolerance", 1e-13);
  y = lsode (rate, start, times).';
endfunction

## uniform rods of 0.5 m from the horizontal: the textbook's two equations in both angles
function [scene, angles] = double_pendulum (times)
  scene = two_rods (0.5, 0.5);
  g = 9.81/0.5;
  function z_dot = rate (z, t)
    [s, c] = deal (sin (z(1) - z(2)), cos (z(1) - z(2)));
    right = [-s*z(4)^2/2 - 1.5*g*cos(z(1)); s*z(3)^2/2 - g*cos(z(2))/2];
    z_dot = [z(3:4); [4/3, c/2; c/2, 1/3] \ right];
  endfunction
  angles = solved (@rate, zeros (4, 1), times)(1:2,:);
endfunction

## crank 0.2 m, rod 0.5 m, a block of 1 kg; it starts with 6 rad/s: one equation, from
## T = m(theta) theta_dot^2/2 and Z (theta)
function [scene, angles] = slider_crank (times)
  [r, l, g] = deal (0.2, 0.5, 9.81);
  scene = two_rods (r, l);
  scene.bodies{1}.initial.phi_dot = 6;
  scene.bodies{2}.initial.phi_dot = -6*r/l;
  scene.bodies{2}.tip_mass = 1;
  scene.bodies{1}.tip_mass = 0;
  scene.bodies = cellfun (@(body) setfield (body, "tip_mass", body.tip_mass), scene.bodies, "uniformoutput", false);
  scene.joints{3} = struct ("kind", "slider", "bodies", 2, "stations", l);
  beta = @(theta) -asin (r/l*sin (theta));
  slope = @(theta) -r*cos (theta)/(l*cos (beta (theta)));  # d beta/d theta
  [m_1, m_2] = deal (2*r, 2*l);
  middle = @(theta) [-r*sin(theta) - l/2*sin(beta (theta))*slope(theta), ...
                     r*cos(theta) + l/2*cos(beta (theta))*slope(theta)];
  block = @(theta) -r*sin (theta) - l*sin (beta (theta))*slope (theta);
  mass = @(theta) m_1*r^2/3 + m_2*sum (middle (theta).^2) + m_2*l^2/12*slope (theta)^2 + block (theta)^2;
  weight = @(theta) g*(m_1*r/2*cos (theta) + m_2*middle (theta)(2));
  mass_slope = @(theta) imag (mass (theta + 1e-30i))/1e-30;
  rate = @(z, t) [z(2); -(mass_slope (z(1))*z(2)^2/2 + weight (z(1)))/mass(z(1))];
  theta = solved (rate, [0; 6], times)(1,:);
  angles = [theta; beta(theta)];
endfunction

%!assert (rigid_mechanisms ("double_pendulum") < 1e-9)
%!assert (rigid_mechanisms ("slider_crank") < 1e-9)
