## -*- texinfo -*-
## @deftypefn {} {@var{fields} =} surface_scene_fields ()
## All fields of a scene of a rod on a surface, beside scene.surface (see @code{surface_functions}), as in
## @code{scene_fields}.
##
## Loads are a moment at the rod's start and one at its end, about the surface's normal, and a force, fixed in space,
## at its end or at force_station; joints are more of them, and springs from places in space (see @code{joint_kinds}:
## forces and points have three numbers).  The section is a rectangle of width along the surface's normal by twice
## half_height, of a material, or what EA, EI, rhoA state, with EI_normal (EI), GJ (0), rhoI (0).  The rotation of a hub
## turns the chart of the rod, with its clamped end, about the chart's origin: on a plane, about its normal, and on a
## sphere, about the vertical axis.  The place moves the end that is held, and the chart with it, by so much of the
## chart's coordinates from initial.point, with two rates, on a plane or a cylinder; initial.velocity is against it.
## Rotary inertia rhoI, per length, is that about the surface's normal; damping is Kelvin's and Voigt's time.  The rod
## starts undeformed, a straight one on a geodesic, one with curvature bent in the tangent plane, from initial.point at
## initial.angle from the chart's first direction to its second, unless initial.shape gives its place.  The first of the
## ends is that of xi = 0.  On a surface with a side the rod lies on that side of it (1: where the normal points, -1:
## the other), 0: it cannot leave it.  The chart's coordinates along the rod are model.modes polynomials and model.sines
## sines beside the start.  The axial force is EA times model.strain: Green's, (5), half the change of the square of the
## stretch, or the engineering strain, the stretch less 1, which Reissner's geometrically exact rod has.  A pixel's
## tolerance is half of one, where the rod fills the frame's smaller side.
## @end deftypefn

function fields = surface_scene_fields ()
  rows = scene_fields ();
  of = @(varargin) rows(ismember (rows(:,1), varargin),:);
  of_rod = rows(strncmp (rows(:,1), "rod.", 4) & ! strcmp (rows(:,1), "rod.curvature_breaks"),:);
  fields = [
    of("title"); of_rod
    {"rod.EI_normal",       [],                 "nonnegative number in N m^2"
     "rod.GJ",              [],                 "nonnegative number in N m^2"}
    of("tip_mass"); of("gravity")
    {"ends",                {"free", "free"},   "two of \"free\", \"hinge\" and \"clamped\""}
    of("moment")
    {"tip_moment",          0,                  "number or function of t in N m"
     "force",               [0 0 0],            "three numbers or function of t in N"}
    of("force_station", "rotation")
    {"place",               [],                 "function of t that returns [x y; x_dot y_dot; x_ddot y_ddot]"}
    of("joints", "moment_breaks", "breaks", "initial.from")
    {"initial.point",       [0 0],              "vector of two coordinates of the chart"
     "initial.angle",       0,                  "number in rad"
     "initial.shape",       [],                 "function of xi that returns the chart's coordinates, 2-by-m"
     "initial.velocity",    [],                 "function of xi and these coordinates that returns their rates, 2-by-m"}
    of("duration", "frames_per_second", "frame_size")
    {"view.elevation",      35,                 "number in degrees"
     "view.azimuth",        30,                 "number in degrees"
     "view.turning",        0,                  "number in degrees per second"
     "model.modes",         "auto",             "\"auto\" or two numbers of polynomials [N1 N2], at least 3 each"
     "model.sines",         [0 0],              "two numbers of sines [N1 N2]"
     "model.strain",        "Green",            "\"Green\" or \"engineering\""
     "solver.name",         "auto",             solver_names({"rate", "residual"})}
    of("solver.step", "solver.rho_infinity", "solver.tolerance")
  ];
endfunction

%!test # the table's kinds are all known
%! for field = surface_scene_fields ().'
%!   assert (ischar (value_error (field{3}, {})));
%! endfor
%!test # what a scene has that says no more than it must: free, at the chart's origin, with nothing but its weight
%! fields = surface_scene_fields ();
%! numbers = fields(cellfun (@(value) isnumeric (value) && ! isempty (value), fields(:,2)),[1 2]);
%! expected = {"rod.length", NaN; "rod.lambda", 1.2e11; "rod.mu", 8.1e10; "rod.density", 7800
%!             "rod.damping", 0; "tip_mass", 0; "gravity", 9.81; "moment", 0; "tip_moment", 0; "force", [0 0 0]
%!             "initial.point", [0 0]; "initial.angle", 0; "duration", NaN; "frames_per_second", 50
%!             "frame_size", [1280 720]; "view.elevation", 35; "view.azimuth", 30; "view.turning", 0; "model.sines", [0 0]
%!             "solver.rho_infinity", 0.8};
%! assert (numbers, expected);
