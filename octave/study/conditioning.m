## -*- texinfo -*-
## @deftypefn {} {@var{table} =} conditioning (@var{folder}, @var{degrees}, @var{sizes})
## The condition number of a curved hinged rod's mass matrix, rotation included and scaled to a diagonal of ones, for
## arcs of so many @var{degrees} with N + N base functions, N of the @var{sizes}: rows of [degrees, N, in the frame of
## Tisserand (see @code{curved_base}), with base functions that are not turned back].  Leaves conditioning.csv in the
## @var{folder} (default output).
## @end deftypefn

function table = conditioning (folder = "output", degrees = [1 30 90 180 300], sizes = [1 2 4 8 16 32])
  require_folder (folder);
  found = zeros (0, 4);
  say ("%8s %4s %12s %12s", "degrees", "N", "Tisserand's", "tangent's");
  for angle = degrees
    rod = struct ("length", 1, "curvature", deg2rad (angle), "EA", 1e6, "EI", 10, "rhoA", 1);
    scene = check_scene (struct ("rod", rod, "duration", 1));
    section = rod_section (scene.rod, scene.model);
    for N = sizes
      [base, arrays] = curved_base (base_functions (1:N, 1:N, 1), scene.rod, section, "uniaxial");
      as_they_are = curved_arrays (rmfield (base, "turned"), base.axis, section, []);
      found(end+1,:) = [angle, N, condition(arrays), condition(as_they_are)];
      say ("%8g %4d %12.3g %12.3g", found(end,:));
    endfor
  endfor
  heads = {"degrees", "N", "Tisserand's frame", "tangent's frame"};
  publish_run (folder, {"conditioning.csv"}, @(aside) write_csv (fullfile (aside, "conditioning.csv"), heads, found));
  if (nargout > 0)
    table = found;
  endif
endfunction

function c = condition (a)
  M = mass_with_rotation (a);
  scale = 1./sqrt (diag (M));
  c = cond (scale.*M.*scale.');
endfunction

%!error <cannot be made|can be written> conditioning ("/proc/nowhere")
%!test # the frame of Tisserand is the better one; the condition grows with the number of functions, no faster
%! [folder, gone] = scratch_folder ();
%! evalc ("table = conditioning (folder, 180, [2 8]);");
%! assert (table(:,3) < table(:,4));
%! assert (table(2,3) < 1.2*4*table(1,3));
%! assert (csvread (fullfile (folder, "conditioning.csv"), 1, 0), table, 1e-9);
%! evalc ("table = conditioning (folder, 0.01, 1);");  # a sine's correlation with the rotation of a straight rod
%! c = sqrt (6)/pi;
%! assert (table, [0.01, 1, 1, (1 + c)/(1 - c)], 1e-3);
%! assert (isempty (strfind (evalc ("conditioning (folder, 180, 2)"), "ans =")));  # nothing is echoed
