## -*- texinfo -*-
## @deftypefn {} {@var{model} =} free_rod_model (@var{body}, @var{rung})
## The model of a mechanism's @var{body} on a @var{rung} of the ladder: as @code{build_model} of a hinged rod, with its
## damping (s) in arrays, which the generated functions take.
##
## Sines fit pinned ends that bear no force along the rod.  rung.sines holds [N1 N2]; rung.corrections and
## rung.elongations, where they are there, are the numbers of base functions (see @code{base_functions}) for ends that
## bear moments and stations that bear forces.  With rung.stiffening = "exact" it is the geometrically exact rod, with
## polynomials (see @code{strain_polynomials}) and their line (see @code{line_points}; empty for others).  equations has
## what is asked of it (see @code{matrix_equations}).
## @end deftypefn

function model = free_rod_model (body, rung)
  more = struct ("elongations", [], "corrections", []);
  for name = intersect (fieldnames (more), fieldnames (rung)).'
    more.(name{1}) = rung.(name{1});
  endfor
  base = base_functions ([1:rung.sines(1), more.elongations], [1:rung.sines(2), more.corrections], body.rod.length);
  exact = strcmp (rung.stiffening, "exact");
  if (exact)
    base.polynomials = true;
  endif
  model = rod_model (body, rung, base);
  model.arrays.damping = body.rod.damping;
  model.line = [];
  model.equations = matrix_equations ();
  if (exact)
    model.line = line_points (model.base, body.rod, model.section, body.tip_mass);
    model.equations = exact_equations ();
  endif
endfunction

%!test # a rigid rod with a mass at its tip
%! rod = struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3, "rhoI", 0, "damping", 0, "curvature", []);
%! body = struct ("rod", rod, "tip_mass", 5, "model", struct ("energy", "uniaxial", "rotary_inertia", true));
%! model = free_rod_model (body, struct ("sines", [0 0], "stiffening", "none"));
%! assert (model.arrays.mass, 11); assert (model.arrays.moment_of_inertia, 3*8/3 + 5*4, 1e-12);
