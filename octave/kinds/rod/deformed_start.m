## -*- texinfo -*-
## @deftypefn {} {[@var{shape}, @var{velocity}] =} deformed_start (@var{scene})
## Where the geometrically exact rod of a checked scene of one straight rod starts in the upright plane, as
## initial.V1, V2 and their rates have it: functions of xi (1-by-m, m), and of xi and the places there, that return
## places (2-by-m, m) and velocities (m/s; see initial.shape of @code{surface_scene_fields}).
##
## What the amplitudes say is how far each point is across the rod's frame, and how much is stretched: the way along
## the frame is that of a rod which is bent so (@code{rod_exact_slope}).  In a hub the tangent at O points as the hub
## does, and velocities are relative to it.
## @end deftypefn

function [shape, velocity] = deformed_start (scene)
  initial = scene.initial;
  [V1, V1_dot] = alike (initial.V1, initial.V1_dot);
  [V2, V2_dot] = alike (initial.V2, initial.V2_dot);
  start.base = base_functions (1:numel (V1), 1:numel (V2), scene.rod.length);
  start.V = [V1; V2];
  start.V_dot = [V1_dot; V2_dot];
  start.axis = panels_between (linspace (0, scene.rod.length, 3 + ceil (numel (start.V)/3)));
  [~, ~, angle, angle_dot] = going_on (start, 0);
  [start.phi, start.phi_dot] = deal (initial.phi, initial.phi_dot);
  if (! isempty (scene.rotation))
    [start.phi, start.phi_dot] = deal (-angle, -angle_dot);
  endif
  [along, along_dot] = going_on (start, start.axis.xi);
  shape = @(xi) in_plane (start, xi, along, start.V);
  velocity = @(xi, places) in_plane (start, xi, along_dot, start.V_dot) ...
                           + start.phi_dot*[-places(2,:); places(1,:)];
endfunction

function [a, b] = alike (a, b)
  n = max (numel (a), numel (b));
  a = postpad (a(:), n);
  b = postpad (b(:), n);
endfunction

function [varargout] = going_on (start, stations)
  [stretch, slope] = functions_at (start.base, stations, 1);
  [varargout{1:nargout}] = rod_exact_slope (slope*start.V, slope*start.V_dot, stretch*start.V, stretch*start.V_dot);
endfunction

function vectors = in_plane (start, xi, along, V)
  [~, across] = functions_at (start.base, xi);
  [x, y] = rod_centreline (start.phi, 0, integrals_to (start.axis, xi)*along, across*V);
  vectors = [x, y].';
endfunction

%!function [shape, velocity, scene] = started (initial, varargin)
%!  scene = check_scene (setfield (swing (), "initial", initial));
%!  [shape, velocity] = deformed_start (setfield (scene, varargin{:}));
%!endfunction
%!test # its length stays where nothing is stretched, and what is across the frame is what the amplitudes say
%! [shape, velocity, scene] = started (struct ("phi", 0.7, "V2", [0.02 -0.01]), "rotation", []);
%! l = scene.rod.length;
%! xi = linspace (0, l, 20001);
%! places = shape (xi);
%! assert (sum (hypot (diff (places(1,:)), diff (places(2,:)))), l, 1e-8*l);
%! across = [-sin(0.7), cos(0.7)]*places;
%! assert (across, 0.02*sin (pi*xi/l) - 0.01*sin (2*pi*xi/l), 1e-12);
%! assert (velocity (xi, places), zeros (2, 20001));
%!test # the velocity is the derivative of the place, as amplitudes and angle go on
%! initial = struct ("phi", 0.7, "phi_dot", 2, "V1", 1e-3, "V2", [0.02 -0.01], "V1_dot", [0.1 0.2], "V2_dot", 3);
%! [shape, velocity] = started (initial, "rotation", []);
%! later = @(h) setfield (setfield (setfield (initial, "phi", 0.7 + 2*h), "V1", [1e-3 + 0.1*h, 0.2*h]), ...
%!                        "V2", [0.02 + 3*h, -0.01]);
%! xi = [0.1 0.3];
%! rates = (started (later (1e-6), "rotation", [])(xi) - started (later (-1e-6), "rotation", [])(xi))/2e-6;
%! assert (velocity (xi, shape (xi)), rates, 1e-8*max (abs (rates(:))));
%!test # in a hub the tangent at O points as the hub does
%! [shape, velocity] = started (struct ("V2", 0.02, "V2_dot", 1), "rotation", @(t) [1 + t, 1, 0]);
%! tangent = shape (1e-6);
%! assert (tangent(2)/tangent(1), 0, 1e-5);
%! rate = velocity (1e-6, tangent);
%! assert (rate(2), 0, 1e-9);
