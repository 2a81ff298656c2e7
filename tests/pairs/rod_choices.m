## -*- texinfo -*-
## @deftypefn {} {[@var{base}, @var{choices}] =} rod_choices ()
## A scene of one rod, and what may be chosen of it: rows of factor, value, and the change that it makes of the scene,
## a cell array of fields and their values.  A factor's first value is that of the @var{base}.
## @end deftypefn

function [base, choices] = rod_choices ()
  base.rod = struct ("length", 1, "width", 0.02, "half_height", 0.005, "lambda", 1e9, "mu", 2e9, "density", 1000);
  base.model.modes = [1 2];
  base.duration = 0.02;
  base.frames_per_second = 200;
  base.solver.tolerance = 1e-5;
  base.solver.step = 1e-4;
  stiffness = struct ("length", 1, "EA", 1e6, "EI", 8, "rhoA", 0.2);
  spin = @(t) [50*t^2, 100*t, 100];
  spring = @(kind, station) struct ("kind", kind, "stations", station, "point", [station, station < 1], ...
                                    "stiffness", 20, "damping", 0.01);
  choices = {
    "section", "material", {}
    "section", "stiffness", {"rod", stiffness}
    "section", "stiffness, rotary inertia, height", ...
      {"rod", setfield(setfield (stiffness, "rhoI", 2e-6), "half_height", 0.005)}
    "curvature", "straight", {}
    "curvature", "arc", {"rod.curvature", [2 -1]}
    "curvature", "function", {"rod.curvature", @(xi) 3*(xi > 0.5), "rod.curvature_breaks", 0.5}
    "damping", "none", {}
    "damping", "some", {"rod.damping", 1e-4}
    "gravity", "earth's", {}
    "gravity", "none", {"gravity", 0}
    "moment", "none", {}
    "moment", "constant", {"moment", 0.2}
    "moment", "pulse", {"moment", @(t) 0.5*(t < 0.01), "moment_breaks", 0.01}
    "rotation", "free", {}
    "rotation", "steady", {"rotation", @(t) [10*t, 10, 0]}
    "rotation", "spin-up", {"rotation", spin}
    "rotation", "held", {"rotation", @(t) [0 0 0]}
    "force", "none", {}
    "force", "across the tip", {"force", @(t) [0 -0.5]}
    "force", "along the middle", {"force", @(t) [5*sin(50*t), 0], "force_station", 0.5}
    "force", "a pulse", {"force", @(t) [0 -0.5]*(t < 0.01), "breaks", 0.01}
    "force", "at O", {"force", @(t) [1 1], "force_station", 0}
    "tip mass", "none", {}
    "tip mass", "some", {"tip_mass", 0.1}
    "joints", "none", {}
    "joints", "a spring at O", {"joints", {spring("torsion_spring", 0)}}
    "joints", "a spring across", {"joints", {spring("spring", 0.5)}}
    "joints", "at the tip", {"joints", {spring("bushing", 1), struct("kind", "moment", "stations", 1, "value", 0.1)}}
    "start", "as it says", {}
    "start", "equilibrium", {"initial.from", "equilibrium"}
    "initial angle", "rest", {}
    "initial angle", "turned, turning", {"initial.phi", 0.5, "initial.phi_dot", 3}
    "initial stretch", "none", {}
    "initial stretch", "some", {"initial.V1", 1e-4, "initial.V1_dot", 0.1}
    "initial bend", "none", {}
    "initial bend", "some", {"initial.V2", [1e-3 1e-4], "initial.V2_dot", 0.01}
    "energy", "paper", {}
    "energy", "uniaxial", {"model.energy", "uniaxial"}
    "axial", "auto", {}
    "axial", "dynamic", {"model.axial", "dynamic"}
    "axial", "quasistatic", {"model.axial", "quasistatic"}
    "axial", "none", {"model.axial", "none"}
    "stiffening", "auto", {}
    "stiffening", "foreshortening", {"model.stiffening", "foreshortening"}
    "stiffening", "none", {"model.stiffening", "none"}
    "work", "tangent", {}
    "work", "chord", {"model.moment_work", "chord"}
    "rotary inertia", "yes", {}
    "rotary inertia", "no", {"model.rotary_inertia", false}
    "modes", "1 + 2", {}
    "modes", "0 + 0", {"model.modes", [0 0]}
    "modes", "2 + 0", {"model.modes", [2 0]}
    "modes", "0 + 3", {"model.modes", [0 3]}
    "modes", "auto", {"model.modes", "auto"}
    "pixels", "no", {}
    "pixels", "tolerance", {"solver.tolerance", "pixel", "zoom", 100}
    "solver", "auto", {}
  };
  for name = {integrator_table(free_rod ([0 0], struct ()).forms).name}
    choices(end+1,:) = {"solver", name{1}, {"solver.name", name{1}}};
  endfor
  choices(end+1,:) = {"solver", "a step by the tolerance", {"solver.name", "implicit_midpoint", "solver.step", []}};
endfunction

%!test # every field of a scene is chosen somewhere, but those of pictures alone
%! text = fileread (which ("rod_choices"));
%! pictures = {"title", "duration", "frames_per_second", "frame_size", "solver.rho_infinity"};
%! for name = setdiff (scene_fields ()(:,1).', pictures)
%!   last = strsplit (name{1}, "."){end};
%!   assert (! isempty (regexp (text, ["[\".]" last "\""])), name{1});
%! endfor
