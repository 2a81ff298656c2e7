## -*- texinfo -*-
## @deftypefn {} {[@var{base}, @var{choices}] =} mechanism_choices ()
## A scene of two rods, and what may be chosen of it, as in @code{rod_choices}: every kind of joint between the first
## rod and the ground, between both rods, and once more, and the fields of the second rod.
## @end deftypefn

function [base, choices] = mechanism_choices ()
  rod = struct ("length", 1, "EA", 1e5, "EI", 8, "rhoA", 0.2, "half_height", 0.005);
  model = struct ("modes", [0 1], "energy", "uniaxial");
  base.bodies = {struct("rod", rod, "model", model), struct("rod", rod, "model", model)};
  base.joints = {joint("revolute", 1, 0)};
  base.duration = 0.01;
  base.frames_per_second = 200;
  base.solver.tolerance = 1e-4;
  base.solver.step = 2e-4;
  kinds = {joint_kinds().name};

  choices = {"ground", "revolute", {}; "ground", "nothing", @(scene) setfield(scene, "joints", {})};
  for kind = kinds(2:end)
    choices(end+1,:) = {"ground", kind{1}, @(scene) setfield(scene, "joints", {joint(kind{1}, 1, 0)})};
  endfor
  choices(end+1,:) = {"between", "revolute", @(scene) with(scene, joint ("revolute", [1 2], [1 0]))};
  choices(end+1,:) = {"between", "nothing", {}};
  for kind = kinds(2:end)
    choices(end+1,:) = {"between", kind{1}, @(scene) with(scene, joint (kind{1}, [1 2], [1 0]))};
  endfor
  choices(end+1,:) = {"beside", "nothing", {}};
  for kind = kinds
    beside = setfield (joint (kind{1}, 2, 1), "point", [2 0]);
    choices(end+1,:) = {"beside", kind{1}, @(scene) with(scene, beside)};
  endfor
  choices = [choices; {
    "curvature", "straight", {}
    "curvature", "arc", second("rod", "curvature", -1)
    "damping", "none", {}
    "damping", "some", second("rod", "damping", 1e-4)
    "section", "stiffness", {}
    "section", "material", second("rod", struct ("length", 1, "width", 0.02, "half_height", 0.005, "mu", 2e9))
    "tip mass", "none", {}
    "tip mass", "some", second("tip_mass", 0.1)
    "axial", "auto", {}
    "axial", "dynamic", second("model", "axial", "dynamic")
    "axial", "none", second("model", "axial", "none")
    "stiffening", "auto", {}
    "stiffening", "foreshortening", second("model", "stiffening", "foreshortening")
    "stiffening", "none", second("model", "stiffening", "none")
    "rotary inertia", "yes", {}
    "rotary inertia", "no", second("model", "rotary_inertia", false)
    "energy", "uniaxial", {}
    "energy", "paper", second("model", "energy", "paper")
    "initial angle", "in line", {}
    "initial angle", "turned, turning", second("initial", struct ("phi", 0.7, "phi_dot", 2))
    "initial bend", "none", {}
    "initial bend", "some", second("initial", "V2", 1e-3)
    "modes", "0 + 1", {}
    "modes", "0 + 0", second("model", "modes", [0 0])
    "modes", "1 + 2", second("model", "modes", [1 2])
    "modes", "auto", second("model", "modes", "auto")
    "gravity", "earth's", {}
    "gravity", "none", {"gravity", 0}
    "solver", "auto", {}
  }];
  for name = {integrator_table({"constrained"}).name}
    choices(end+1,:) = {"solver", name{1}, {"solver.name", name{1}}};
  endfor
endfunction

function change = second (varargin)
  change = @(scene) setfield (scene, "bodies", {scene.bodies{1}, setfield(scene.bodies{2}, varargin{:})});
endfunction

function scene = with (scene, joint)
  scene.joints{end+1} = joint;
endfunction

function joint = joint (kind, bodies, stations)
  joint = struct ("kind", kind, "bodies", bodies, "stations", stations);
  values = struct ("angle", @(t) [t^2, 2*t, 2], "position", @(t) [0 t^2/2; 0 t; 0 1], "moment", 0.5, ...
                   "force", @(t) [0, sin(50*t)]);
  if (isfield (values, kind))
    joint.value = values.(kind);
  elseif (any (strcmp (kind, {"spring", "torsion_spring", "bushing"})))
    [joint.stiffness, joint.damping] = deal (100, 0.1);
  endif
endfunction

%!test # all kinds stand at each place, and what is chosen is a scene
%! [base, choices] = mechanism_choices ();
%! for place = {"ground", "between", "beside"}
%!   assert (ismember ({joint_kinds().name}, choices(strcmp (choices(:,1), place{1}),2)));
%! endfor
%! check_mechanism (base);
