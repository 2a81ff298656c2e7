## -*- texinfo -*-
## @deftypefn {} {@var{fields} =} scene_fields ()
## All fields of a scene, a row each: name, default, kind (see @code{value_error}).  A default of NaN means that the
## field must be given; breaks, or in short moment_breaks, are those of all loads, whose functions take one t (the
## moment's: many); jumps that they leave out are found (see @code{load_breaks}).
## @end deftypefn

function fields = scene_fields ()
  fields = {
    "title",                 "",             "text"
    "rod.length",            NaN,            "positive number in m"
    "rod.width",             [],             "positive number in m"
    "rod.half_height",       [],             "positive number in m"
    "rod.lambda",            1.2e11,         "nonnegative number in Pa"
    "rod.mu",                8.1e10,         "positive number in Pa"
    "rod.density",           7800,           "positive number in kg/m^3"
    "rod.EA",                [],             "positive number in N"
    "rod.EI",                [],             "positive number in N m^2"
    "rod.rhoA",              [],             "positive number in kg/m"
    "rod.rhoI",              [],             "nonnegative number in kg m"
    "rod.curvature",         [],             "vector or function of xi in 1/m"
    "rod.curvature_breaks",  [],             "vector of stations in m"
    "rod.damping",           0,              "nonnegative number in s"
    "gravity",               9.81,           "number in m/s^2"
    "moment",                0,              "number or function of t in N m"
    "moment_breaks",         [],             "vector of times in s"
    "breaks",                [],             "vector of times in s"
    "rotation",              [],             "function of t that returns [theta theta_dot theta_ddot]"
    "force",                 [],             "function of t that returns [F_x F_y] in N"
    "force_station",         [],             "nonnegative number in m"
    "tip_mass",              0,              "nonnegative number in kg"
    "joints",                {},             "struct array, or cell array of structs"
    "initial.from",          "",             "text"
    "initial.phi",           0,              "number in rad"
    "initial.phi_dot",       0,              "number in rad/s"
    "initial.V1",            [],             "vector of amplitudes in m"
    "initial.V2",            [],             "vector of amplitudes in m"
    "initial.V1_dot",        [],             "vector of rates in m/s"
    "initial.V2_dot",        [],             "vector of rates in m/s"
    "duration",              NaN,            "positive number in s"
    "frames_per_second",     50,             "positive number in 1/s"
    "zoom",                  1,              "nonnegative number"
    "frame_size",            [1280 720],     "two even numbers of pixels from 320 to 8192 [W H]"
    "model.modes",           "auto",         "\"auto\" or two numbers of modes [N1 N2]"
    "model.energy",          "paper",        "\"paper\" or \"uniaxial\""
    "model.axial",           "auto",         "\"auto\", \"dynamic\", \"quasistatic\" or \"none\""
    "model.stiffening",      "auto",         "\"auto\", \"foreshortening\" or \"none\""
    "model.moment_work",     "tangent",      "\"tangent\" or \"chord\""
    "model.rotary_inertia",  true,           "true or false"
    "solver.name",           "auto",         solver_names({"rate", "oscillators", "momenta", "accelerations"})
    "solver.step",           [],             "positive number in s"
    "solver.rho_infinity",   0.8,            "number from 0 to 1"
    "solver.tolerance",      "pixel",        "\"pixel\" or positive number in m"
  };
endfunction

%!test # the table's kinds are all known
%! for field = scene_fields ().'
%!   assert (ischar (value_error (field{3}, {})));
%! endfor
%!test # a scene that says no more than it must: the paper's steel in the earth's gravity, of which nothing else acts
%! fields = scene_fields ();
%! numbers = fields(cellfun (@(value) isnumeric (value) && ! isempty (value), fields(:,2)),[1 2]);
%! expected = {"rod.length", NaN; "rod.lambda", 1.2e11; "rod.mu", 8.1e10; "rod.density", 7800; "rod.damping", 0
%!             "gravity", 9.81; "moment", 0; "tip_mass", 0; "initial.phi", 0; "initial.phi_dot", 0; "duration", NaN
%!             "frames_per_second", 50; "zoom", 1; "frame_size", [1280 720]; "solver.rho_infinity", 0.8};
%! assert (numbers, expected);
