## -*- texinfo -*-
## @deftypefn {} {@var{off} =} chain_frequencies (@var{n})
## Small oscillations of a hanging chain of @var{n} rigid rods: in each mode of its linearisation (uniform rods:
## M_jk and K_jk of the angles in closed form) the mechanism returns after a period; the largest difference, as a
## part of the amplitude.
## @end deftypefn

function off = chain_frequencies (n)
  [l, g, amplitude] = deal (0.1, 9.81, 1e-5);
  [k, j] = meshgrid (1:n, 1:n);
  M = l*(n - max (j, k) + 1/2) - l*eye (n)/6;  # per mass times length
  K = g*diag (n - (1:n) + 1/2);
  [modes, squares] = eig (K, M);
  off = 0;
  for i = 1:n
    x = amplitude*modes(:,i)/max (abs (modes(:,i)));
    scene = setfield (chain (n), "duration", 2*pi/sqrt (squares(i,i)));
    for b = 1:n
      scene.bodies{b}.model.modes = [0 0];
      scene.bodies{b}.rod = struct ("length", l, "EA", 1, "EI", 1, "rhoA", 1, "rhoI", 0);
      scene.bodies{b}.initial.phi = -pi/2 + x(b);
    endfor
    scene = check_mechanism (scene);
    mechanism = build_mechanism (scene, mechanism_rungs (scene, zeros (1, n)));
    system = mechanism_system (scene, mechanism);
    start = assemble_mechanism (scene, mechanism, system);
    states = integrate_constrained (system, [0 scene.duration], start, struct ("name", "radau", "tolerance", 1e-11));
    off = max (off, max (abs (states.q(:,2) - start.q))/amplitude);
  endfor
endfunction

%!assert (chain_frequencies (3) < 1e-5)
