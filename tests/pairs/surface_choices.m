## -*- texinfo -*-
## @deftypefn {} {[@var{base}, @var{choices}] =} surface_choices ()
## A scene of a rod on a surface, and what may be chosen of it, as in @code{rod_choices}.
## @end deftypefn

function [base, choices] = surface_choices ()
  base.surface = struct ("name", "plane", "inclination", 1);
  base.rod = struct ("length", 0.4, "EA", 100, "EI", 0.02, "rhoA", 0.2);
  base.model.modes = [4 4];
  base.duration = 0.002;  # explicit methods take short steps where many polynomials are chosen
  base.frames_per_second = 1000;
  base.solver.tolerance = 1e-3;
  choices = {
    "surface", "plane", {}
    "surface", "cylinder", {"surface", struct("name", "cylinder", "radius", 1)}
    "surface", "cone", {"surface", struct("name", "cone", "half_angle", 0.6), "initial.point", [1 0]}
    "surface", "sphere", {"surface", struct("name", "sphere", "radius", 1)}
    "surface", "torus", {"surface", struct("name", "torus", "core_radius", 1, "tube_radius", 0.5)}
    "surface", "saddle", {"surface", struct("name", "saddle", "rise", 1, "fall", 0.5)}
    "surface", "bumps", {"surface", struct("name", "bumps", "height", 0.1, "wave_number_1", 2, "wave_number_2", 3)}
    "side", "normal", {}
    "side", "other", {"surface.side", -1}
    "side", "both", {"surface.side", 0}
  };
  for start = {"free", "hinge", "clamped"}
    for tip = {"free", "hinge", "clamped"}
      choices(end+1,:) = {"ends", [start{1} ", " tip{1}], {"ends", {start{1}, tip{1}}}};
    endfor
  endfor
  choices = [choices; {
    "force", "none", {}
    "force", "constant", {"force", [0.5 0 0.2]}
    "force", "function", {"force", @(t) [0, sin(50*t), 0]}
    "force", "on the way", {"force", [0.5 0 0.2], "force_station", 0.1}
    "tip mass", "none", {}
    "tip mass", "some", {"tip_mass", 0.05}
    "joints", "none", {}
    "joints", "a spring, a force and a moment", {"joints", joints()}
    "hub", "none", {}
    "hub", "turns", {"rotation", @(t) [t^2, 2*t, 2]}
    "place", "stays", {}
    "place", "moves", {"place", @(t) [t^2, 0.1*t^2; 2*t, 0.2*t; 2, 0.2]}
    "axis", "straight", {}
    "axis", "an arc", {"rod.curvature", 0.5}
    "axis", "a function", {"rod.curvature", @(xi) sin(9*xi)}
    "damping", "none", {}
    "damping", "some", {"rod.damping", 1e-3}
    "moment", "none", {}
    "moment", "pulse", {"moment", @(t) 0.05*(t < 0.001), "moment_breaks", 0.001}
    "tip moment", "none", {}
    "tip moment", "constant", {"tip_moment", 0.05}
    "gravity", "earth's", {}
    "gravity", "none", {"gravity", 0}
    "stiffness", "one", {}
    "stiffness", "three", {"rod.EI_normal", 0.01, "rod.GJ", 0.01}
    "stiffness", "a material's", {"rod", struct("length", 0.4, "width", 0.01, "half_height", 0.011, ...
                                               "lambda", 1e6, "mu", 1e6, "density", 1000)}
    "strain", "Green's", {}
    "strain", "engineering", {"model.strain", "engineering"}
    "rotary inertia", "none", {}
    "rotary inertia", "some", {"rod.rhoI", 1e-6}
    "laid", "along", {}
    "laid", "aslant", {"initial.angle", 0.6}
    "laid", "a shape", @(scene) shaped(scene)
    "velocity", "rest", {}
    "velocity", "some", {"initial.velocity", @(xi, alpha) 0.5 + 0*alpha}
    "modes", "4 + 4", {}
    "modes", "4 + 4, sines", {"model.sines", [2 2]}
    "modes", "auto", {"model.modes", "auto"}
    "solver", "auto", {}
  }];
  for name = {integrator_table({"rate", "residual"}).name}
    choices(end+1,:) = {"solver", name{1}, {"solver.name", name{1}}};
  endfor
endfunction

function given = joints ()
  given = {struct("kind", "spring", "stations", 0.3, "point", [0 0 1], "stiffness", 2, "damping", 0.1)
           struct("kind", "force", "stations", 0.2, "value", [0 0.1 0])
           struct("kind", "moment", "stations", 0.2, "value", @(t) 0.01*sin(50*t))};
endfunction

## an arc in the chart
function scene = shaped (scene)
  from = [0; 0];
  if (isfield (scene, "initial"))
    from = scene.initial.point(:);
  endif
  scene.initial.shape = @(xi) from + [xi; 0.2*xi.^2];
endfunction

%!test # every surface and every solver is there
%! [~, choices] = surface_choices ();
%! fields = surface_scene_fields ();
%! kind = fields{strcmp (fields(:,1), "solver.name"),3};
%! assert (sum (strcmp (choices(:,1), "solver")), numel (strfind (kind, "\""))/2);
