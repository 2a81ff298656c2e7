## -*- texinfo -*-
## @deftypefn {} {@var{surface} =} surface_functions (@var{given})
## The derived functions of the surface @var{given}, a struct of its name and its parameters: a struct of position,
## tangent, normal, laid, mass, balance, damping, turning, rotary_balance, energies, strains, section, point_loads,
## spring, reaction, damped_reaction, angle, direction and support, which take the arguments of
## generated/surface_NAME_*.m but for the surface, with arrays of any size; and units of the chart's two coordinates.
##
## Surfaces of one's own (`make derive SURFACE=file') are found in output/surfaces/.  Unknown names, missing and
## unknown parameters and such that are negative are errors.
## @end deftypefn

function surface = surface_functions (given)
  root = fileparts (fileparts (which ("driver")));
  own = fullfile (root, "output", "surfaces");
  if (isfolder (own) && isempty (strfind (path (), own)))
    addpath (own);
  endif
  if (! (isstruct (given) && isscalar (given) && isfield (given, "name") && ischar (given.name)))
    scene_error ("surface is no struct with a name: it takes one of %s with its parameters", ...
                 names_of_surfaces (root, own));
  elseif (! exist (["surface_" given.name "_position"], "file"))
    scene_error ("surface.name is \"%s\": it takes one of %s, or what `make derive SURFACE=file' has derived", ...
                 given.name, names_of_surfaces (root, own));
  endif
  [parameters, surface.units] = signature_of (given.name);
  parameters = values_of (rmfield (given, "name"), parameters, given.name);
  for kind = {"position", "tangent", "normal", "laid", "mass", "balance", "damping", "turning", "rotary_balance", ...
              "energies", "strains", "section", "point_loads", "spring", "reaction", "damped_reaction", "angle", ...
              "direction", "support"}
    name = sprintf ("surface_%s_%s", given.name, kind{1});
    if (! exist (name, "file"))
      scene_error ("surface.name is \"%s\": an earlier `make derive SURFACE=file' left no %s: derive it again", ...
                   given.name, name);
    endif
    derived = str2func (name);
    surface.(kind{1}) = @(varargin) derived (varargin{:}, parameters{:});
  endfor
endfunction

function names = names_of_surfaces (root, own)
  files = [glob(fullfile (root, "generated", "surface_*_position.m")); glob(fullfile (own, "surface_*_position.m"))];
  names = strjoin (regexprep (files.', '.*surface_(\w+)_position\.m$', '$1'), ", ");
endfunction

## as the derived function's description has them
function [parameters, units] = signature_of (name)
  text = fileread (which (["surface_" name "_position"]));
  parameters = [regexp(text, '@item @var\{surface\}\.(\w+)', "tokens"){:}];
  units = [regexp(text, '@item @var\{place\}\.alpha\d \(array, ([^)]*)\)', "tokens"){:}];
endfunction

function values = values_of (given, names, surface)
  unknown = setdiff (fieldnames (given).', [names, {"side"}]);
  if (! isempty (unknown))
    scene_error ("surface.%s is not a parameter of the %s: those are %s", unknown{1}, surface, strjoin (names, ", "));
  endif
  values = {};  # of a surface without parameters
  for name = names
    if (! isfield (given, name{1}))
      scene_error ("surface.%s is missing: it takes a nonnegative number", name{1});
    endif
    value = given.(name{1});
    got = value_error ("nonnegative number", value);
    if (! isempty (got))
      scene_error ("surface.%s is %s: it takes a nonnegative number", name{1}, got);
    endif
    values{1}.(name{1}) = value;
  endfor
endfunction

%!test # the lowest point of a lying cylinder, and its normal
%! surface = surface_functions (struct ("name", "cylinder", "radius", 2));
%! [x, y, z] = surface.position (struct ("alpha1", [0 1], "alpha2", [0 0]));
%! assert ([x; y; z], [0 1; 0 0; -2 -2], 1e-15);
%! [n_1, n_2, n_3, determinant] = surface.normal (struct ("alpha1", 0, "alpha2", 0));
%! assert ([n_1 n_2 n_3 determinant], [0 0 1 1], 1e-15);
%!test # the chart of a cone is of lengths and angles
%! assert (surface_functions (struct ("name", "cone", "half_angle", 1)).units, {"m", "rad"});
%!error <surface.name is "egg": it takes one of bumps, cone, cylinder, plane, saddle, sphere, torus>
%! surface_functions (struct ("name", "egg"))
%!error <surface.radius is missing> surface_functions (struct ("name", "sphere"))
%!error <surface.radius is -1: it takes a nonnegative number> surface_functions (struct ("name", "sphere", "radius", -1))
%!error <surface.height is not a parameter of the sphere: those are radius>
%! surface_functions (struct ("name", "sphere", "radius", 1, "height", 2))
%!error <surface is no struct with a name> surface_functions (3)
