## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{body}] =} mechanism_fields ()
## All fields of a scene with several bodies and of each of its bodies, a row each: name, default, kind (see
## @code{value_error}).  rod and model of a body are those of a scene with one rod (see @code{scene_fields}); joints
## have @code{joint_fields}.
##
## model.stiffening = "exact" makes a body the geometrically exact rod (see @code{exact_equations}), with polynomials
## instead of sines; pieces is how many welded pieces each straight rod is divided into (see @code{in_pieces}).
## initial.x, initial.y (m) are the place of the body's end O, initial.x_dot, initial.y_dot (m/s) its velocity; without
## them they are what its first joint makes them.
## @end deftypefn

function [scene, body] = mechanism_fields ()
  rod = scene_fields ();
  of = @(prefix) rod(strncmp (rod(:,1), prefix, numel (prefix)),:);
  scene = [
    of("title"); of("gravity"); of("duration"); of("frames_per_second"); of("frame_size"); of("zoom")
    {"solver.name", "auto", solver_names({"constrained"})}
    of("initial.from"); of("solver.step"); of("solver.rho_infinity"); of("solver.tolerance")
    {"solver.baumgarte", 100, "positive number in 1/s"
     "bodies", NaN, "struct array, or cell array of structs"
     "pieces", 1, "whole number from 1 to 50, pieces of each straight rod"
     "joints", {}, "struct array, or cell array of structs"
     "breaks", [], "vector of times in s"}
  ];
  initial = {
    "initial.x",       [], "number in m"
    "initial.y",       [], "number in m"
    "initial.phi",     0,  "number in rad"
    "initial.x_dot",   [], "number in m/s"
    "initial.y_dot",   [], "number in m/s"
    "initial.phi_dot", 0,  "number in rad/s"
  };
  stiffening = {"model.stiffening", "auto", "\"auto\", \"exact\", \"foreshortening\" or \"none\""};
  body = [{"name", "", "text"}; of("rod."); of("tip_mass"); initial; of("initial.V"); of("model.modes");
          of("model.energy"); of("model.axial"); stiffening; of("model.rotary_inertia")];
endfunction

%!test
%! [scene, body] = mechanism_fields ();
%! joint = joint_fields ();
%! assert (any (strcmp ("rod.length", body(:,1)))); assert (columns (joint), 3);
%!test # what bodies and joints have that say no more than they must: nothing acts, and nothing gives way
%! [scene, body] = mechanism_fields ();
%! joint = joint_fields ();
%! of = @(fields, names) cellfun (@(name) fields{strcmp(fields(:,1), name),2}, names, "uniformoutput", false);
%! assert (of (scene, {"solver.baumgarte", "bodies", "joints", "breaks"}), {100, NaN, {}, []});
%! assert (of (joint, {"kind", "bodies", "stations", "point", "direction", "value", "stiffness", "damping", ...
%!   "rest"}), ...
%!         {NaN, NaN, [], [0 0], 0, 0, 0, 0, 0});
%! assert (of (body, {"initial.phi", "initial.phi_dot", "initial.x", "initial.y_dot", "tip_mass"}), {0, 0, [], [], 0});
