## -*- texinfo -*-
## @deftypefn {} {@var{what} =} exact_lacks (@var{scene})
## What the geometrically exact rod (see @code{exact_scene}) lacks of a checked scene of one rod, in words; empty where
## it lacks nothing.
## @end deftypefn

function what = exact_lacks (scene)
  what = "";
  if (! isempty (scene.rod.curvature))
    what = what_curved_one_lacks (scene);
  endif
  if (! isempty (what))
    return;
  elseif (! isempty (scene.initial.from))
    what = "another run's end, or an equilibrium, as its start";
  elseif (! all (ismember ({scene.joints.kind}, {"spring", "force", "moment"})))
    what = "joints but springs, forces and moments";
  elseif (strcmp (scene.model.moment_work, "chord"))
    what = "work of the moment on the chord's rotation";
  elseif (! any (strcmp (scene.solver.name, {"auto", integrator_table(forms_of (scene)).name})))
    what = sprintf ("the solver %s", scene.solver.name);
  endif
endfunction

## on the plane, or as a body
function forms = forms_of (scene)
  forms = {"rate", "residual"};
  if (! isempty (scene.rod.curvature))
    forms = {"constrained"};
  endif
endfunction

## where a rod is thick against its radius, layers inside of its axis are shorter than those outside
function what = what_curved_one_lacks (scene)
  what = "";
  initial = scene.initial;
  if (too_thick (scene.rod, rod_section (scene.rod, scene.model)))
    what = "a rod so thick that its curvature changes its section";
  elseif (any ([initial.V1(:); initial.V2(:); initial.V1_dot(:); initial.V2_dot(:)]))
    what = "a deformed start of a curved axis";
  endif
endfunction

%!test # what it has not
%! lacks = @(varargin) nthargout (2, @exact_scene, check_scene (setfield (arc_pendulum (), varargin{:})));
%! assert (lacks ("gravity", 9), "");
%! assert (lacks ("initial", "V2", 1e-3), "a deformed start of a curved axis");
%! assert (lacks ("rod", "half_height", 0.05), "a rod so thick that its curvature changes its section");
%! [plane, lacks] = exact_scene (check_scene (setfield (swing (), "initial", "from", "equilibrium")));
%! assert (plane, []); assert (! isempty (strfind (lacks, "equilibrium")));
%! scene = setfield (swing (), "joints", {struct("kind", "torsion_spring", "stations", 0, "stiffness", 1)});
%! [~, lacks] = exact_scene (check_scene (scene));
%! assert (! isempty (strfind (lacks, "joints but springs")));
%! lacks = nthargout (2, @exact_scene, check_scene (setfield (swing (), "solver", "name", "waveform")));
%! assert (lacks, "the solver waveform");
