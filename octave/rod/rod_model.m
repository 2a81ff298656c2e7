## -*- texinfo -*-
## @deftypefn {} {@var{model} =} rod_model (@var{body}, @var{rung}, @var{base})
## The model of a @var{body} (checked fields rod, model and tip_mass) of a @var{rung} of a ladder with all functions of
## a @var{base} (see @code{base_functions}): a struct of rung, length, section, shortening (1 or 0), base, which has an
## axis where the rod is curved or geometrically exact (see @code{curved_base}), arrays (see @code{rod_arrays}, with
## slope_1, slope_2 of (27)), basis (the identity) and followers (empty).
## @end deftypefn

function model = rod_model (body, rung, base)
  model.rung = rung;
  model.length = body.rod.length;
  model.section = rod_section (body.rod, body.model);
  model.shortening = double (strcmp (rung.stiffening, "foreshortening"));
  model.base = base;
  if (isempty (body.rod.curvature) && ! strcmp (rung.stiffening, "exact"))
    arrays = rod_arrays (base, model.section, model.shortening);
    if (body.tip_mass > 0)
      arrays = add_point_mass (arrays, base, model.length, body.tip_mass, model.shortening);
    endif
  else
    [model.base, arrays] = curved_base (base, body.rod, model.section, body.model.energy, body.tip_mass);
  endif
  [arrays.slope_1, arrays.slope_2] = slopes_at (model.base, 0, model.shortening);
  model.arrays = arrays;
  model.basis = eye (columns (arrays.mass_matrix));
  model.followers = [];
endfunction

%!test # a tip mass is in the arrays of a straight rod and of a curved one
%! body.rod = struct ("length", 2, "EA", 10, "EI", 1, "rhoA", 3, "rhoI", 0, "curvature", [], "curvature_breaks", []);
%! body.model = struct ("energy", "uniaxial", "rotary_inertia", false);
%! [body.tip_mass, rung.stiffening] = deal (5, "none");
%! base = base_functions (1, 1:2, 2);
%! straight = rod_model (body, rung, base);
%! assert (straight.arrays.moment_of_inertia, 3*8/3 + 5*4, 1e-9); assert (straight.basis, eye (3));
%! body.rod.curvature = 1e-6;
%! curved = rod_model (body, rung, base);
%! assert (curved.arrays.moment_of_inertia, straight.arrays.moment_of_inertia, 1e-5);
%! assert (isfield (curved.base, "axis") && ! isfield (straight.base, "axis"));
