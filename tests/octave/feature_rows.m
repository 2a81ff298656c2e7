## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} feature_rows ()
## What a scene can have, for @code{feature_table}: rows of the feature's name; the fields that give it to one rod,
## to a mechanism and to a rod on a surface, with values; and the reasons of the table's four columns where it is
## refused ("": not yet).
##
## Of a mechanism the fields are its second body's, or it is a joint.  Without fields (@{@}) the reasons are the cells.
## @end deftypefn

function rows = feature_rows ()
  material = struct ("length", 1, "width", 0.02, "half_height", 0.005, "lambda", 1e9, "mu", 2e9, "density", 1000);
  stiffness = struct ("length", 1, "EA", 1e5, "EI", 8, "rhoA", 0.2);
  at_rest = @(t) [0 0 0];
  joint = @(kind, station, value) struct ("kind", kind, "bodies", 2, "stations", station, "point", [1.5 0], ...
                                          "value", value);
  angle = joint ("angle", 0, at_rest);
  place = joint ("position", 0, @(t) [1.5 0; 0 0; 0 0]);
  spring = setfield (joint ("spring", 1, 0), "stiffness", 100);
  on_one = @(joint) rmfield (joint, "bodies");
  on_surface = struct ("kind", "spring", "stations", 0.3, "point", [0 0 1], "stiffness", 10);
  hinge = struct ("kind", "revolute", "bodies", [1 2], "stations", [1 0]);
  none = {"", "", "", ""};
  as_body = {"as a body of a mechanism", "as a body of a mechanism", "", ""};
  as_body_if_curved = {"", "as a body of a mechanism", "", ""};
  rows = {
    "section by material", {"rod.width", 0.03, "rod.mu", 1e9}, {"rod", material}, {"rod", material}, none
    "section by stiffness", {"rod.EA", 1e5, "rod.EI", 8, "rod.rhoA", 0.2}, {"rod", stiffness}, {"rod", stiffness}, none
    "curved axis", {}, {"rod.curvature", -1}, {"rod.curvature", -1}, {"that is the next column", "yes", "", ""}
    "rotary inertia", {"model.rotary_inertia", true}, {"model.rotary_inertia", true}, {"rod.rhoI", 1e-6}, none
    "damping of the material", {"rod.damping", 1e-4}, {"rod.damping", 1e-4}, {"rod.damping", 1e-4}, none
    "tip mass", {"tip_mass", 0.1}, {"tip_mass", 0.1}, {"tip_mass", 0.1}, none
    "force at the tip", {"force", @(t) [0 1]}, joint("force", 1, [0 1]), {"force", [0 0 1]}, as_body_if_curved
    "force on the way", {"force", @(t) [0 1], "force_station", 0.5}, joint("force", 0.5, [0 1]), ...
      {"force", [0 0 1], "force_station", 0.2}, as_body_if_curved
    "moment at O", {"moment", 0.1}, joint("moment", 0, 0.1), {"moment", 0.01}, none
    "moment elsewhere", {"joints", {on_one(joint ("moment", 1, 0.1))}}, joint("moment", 1, 0.1), ...
      {"tip_moment", 0.01}, none
    "springs, dampers", {"joints", {on_one(spring)}}, spring, {"joints", {on_surface}}, none
    "joints between rods", {"joints", {hinge}}, hinge, {"joints", {hinge}}, ...
      {"one rod has none", "one rod has none", "", "one rod has none"}
    "prescribed rotation", {"rotation", at_rest}, angle, ...
      {"rotation", at_rest, "ends", {"clamped", "free"}}, as_body_if_curved
    "prescribed place", {"place", place.value}, place, {"place", place.value, "ends", {"hinge", "free"}}, as_body
    "start deformed", {"initial.V2", 1e-3}, {"initial.V2", 1e-3}, {"initial.shape", @(xi) [xi; xi.^2]}, none
    "foreshortening", {"model.stiffening", "foreshortening"}, {"model.stiffening", "foreshortening"}, ...
      {"model.stiffening", "foreshortening"}, ...
      {"", "its strains are linear: the geometrically exact rod has it", "", "always: displacements are large"}
    "geometrically exact", {}, {"model.stiffening", "exact"}, {}, ...
      {"`EXACT=yes`", "`EXACT=yes`, where it is thin", "", "always"}
    "longitudinal modes without inertia", {"model.axial", "quasistatic"}, {"model.axial", "quasistatic"}, ...
      {"model.axial", "quasistatic"}, ...
      {"", "`waveform` has them exactly", "`radau` lets stiff ones follow", "stretching is no coordinate of its own"}
    "number of modes chosen", {"model.modes", "auto"}, {"model.modes", "auto"}, {"model.modes", "auto"}, none
  };
endfunction

%!test # a reason for each column
%! for row = feature_rows ().'
%!   assert (size (row{5}), [1 4]); assert (iscellstr (row{5}));
%! endfor
