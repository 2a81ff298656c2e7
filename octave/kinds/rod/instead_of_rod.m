## -*- texinfo -*-
## @deftypefn {} {@var{text} =} instead_of_rod (@var{scene})
## What to take for a checked scene of one rod where all its models drop too much (see @code{dropped_of_rod}), in words.
## @end deftypefn

function text = instead_of_rod (scene)
  text = exact_instead ();
  if (! isempty (exact_scene (scene)))
    return;
  elseif (isempty (scene.rod.curvature))
    text = welded_rods ();
  else
    text = "take a stiffer rod or smaller loads, a curved rod's strains are linear in its displacements";
  endif
endfunction

%!test # the exact rod is spoken of where it can be had
%! instead = @(varargin) instead_of_rod (check_scene (setfield (paper (), varargin{:})));
%! exact = @(text) ! isempty (strfind (text, "EXACT=yes"));
%! assert (exact (instead ("tip_mass", 1)));
%! assert (exact (instead_of_rod (check_scene (spin_up ()))));
%! assert (! exact (instead ("initial", "from", "equilibrium")));
%! assert (! isempty (strfind (instead ("initial", "from", "equilibrium"), "weld")));
%! assert (exact (instead_of_rod (check_scene (arc_pendulum ()))));
%! thick = instead_of_rod (check_scene (setfield (hook (), "rod", "half_height", 0.01)));
%! assert (! isempty (strfind (thick, "linear in its displacements")));
