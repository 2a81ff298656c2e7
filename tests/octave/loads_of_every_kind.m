## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} loads_of_every_kind (@var{kind}, @var{load})
## A rigid scene of 20 s in which the function @var{load} of t (N m, one t or many) turns a rod of 1 m about its end:
## "hinged", "mechanism" (as a joint's value) or "surface" (on a level plane).
## @end deftypefn

function scene = loads_of_every_kind (kind, load)
  rod = struct ("length", 1, "EA", 1e6, "EI", 1e5, "rhoA", 3);
  scene = struct ("gravity", 0, "duration", 20, "frames_per_second", 1);
  switch (kind)
    case "hinged"
      scene.rod = rod;
      scene.model.modes = [0 0];
      scene.moment = load;
    case "mechanism"
      scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0]))};
      scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
                      struct("kind", "moment", "bodies", 1, "stations", 0, "value", load)};
    case "surface"
      scene.rod = setfield (setfield (rod, "EA", 100), "EI", 10);
      scene.surface = struct ("name", "plane", "inclination", 0);
      scene.ends = {"hinge", "free"};
      scene.model.modes = [4 4];
      scene.moment = load;
      scene.solver.tolerance = 1e-3;
  endswitch
endfunction

%!function phi = angle_of (kind, load)
%!  result = driver (loads_of_every_kind (kind, load), "output", "");
%!  assert ([result.summary.loads.breaks], [12.3 12.35], 1e-14);
%!  switch (kind)
%!    case "hinged"
%!      phi = result.history.phi(end);
%!    case "mechanism"
%!      phi = result.history.bodies.phi(end);
%!    case "surface"
%!      phi = unwrap (atan2 (result.history.tip(2,:), result.history.tip(1,:)))(end);
%!  endswitch
%!endfunction
%!test # a blow of 0.05 s in 20 s, whose times nobody states: M dt/J, J = rhoA l^3/3, from its middle on; of two shapes
%! jump = @(t) 10*(t > 12.3 & t < 12.35);
%! sine = @(t) jump (t).*sin (pi*(t - 12.3)/0.05)*pi/2;
%! for kind = {"hinged", "mechanism"}
%!   for load = {jump, sine}
%!     assert (angle_of (kind{1}, load{1}), 10*0.05/1*(20 - 12.325), 1e-7);
%!   endfor
%! endfor
%!test # on a surface, where the rod stretches and bends a little
%! assert (angle_of ("surface", @(t) 10*(t > 12.3 & t < 12.35)), 10*0.05/1*(20 - 12.325), 0.03);
%!function message = refused (kind, load)
%!  message = "";
%!  folder = tempname ();
%!  try
%!    driver (loads_of_every_kind (kind, load), "output", folder);
%!  catch err
%!    message = strtrim (err.message);
%!  end_try_catch
%!  assert (exist (folder, "dir"), 0);
%!endfunction
%!function M = calm_until_7 (t)
%!  M = 0*t;
%!  if (any (t >= 7))
%!    error ("no wind");
%!  endif
%!endfunction
%!test # a gap, a failure, a complex number, another size: named with the time, nothing written
%! for kind = {"hinged", "moment"; "mechanism", "joints(2).value"; "surface", "moment"}.'
%!   check = @(load, text) assert (strncmp (refused (kind{1}, load), [kind{2} " " text], numel ([kind{2} " " text])));
%!   check (@(t) 0./(t < 0.6 | t > 0.8), "gives NaN at t = 0.6: it takes");
%!   check (@(t) calm_until_7 (t), "fails at t = 7: no wind");
%!   check (@(t) sqrt (3 - t), "gives 0+");
%!   check (@(t) 1./(t - 20), "gives ");
%! endfor
%! said = refused ("mechanism", @(t) ones (1, 1 + (t > 5)));
%! assert (! isempty (strfind (said, "joints(2).value gives [1 1] at t = 5:")));
%!test # a load that is bad only between the times looked at: known in the run, and noted
%! near = @(t, c) abs (t*c - round (t*c)) < 1e-6;
%! good = @(t) near (t, 20010/20) | near (t, 4000/20) | near (t, 10);
%! for kind = {"hinged", "moment"; "mechanism", "joints(2).value"; "surface", "moment"}.'
%!   [folder, gone] = scratch_folder ();
%!   try
%!     driver (loads_of_every_kind (kind{1}, @(t) 0./good (t)), "output", folder);
%!     said = "";
%!   catch err
%!     said = strtrim (err.message);
%!   end_try_catch
%!   text = [kind{2} " gives a number that is not finite at t = "];
%!   assert (strncmp (said, text, numel (text)));
%!   assert (jsondecode (fileread (fullfile (folder, "summary.json"))).last_failure.message, said);
%! endfor
%!test # the paper's moment with and without its break: the same digits
%! of = @(breaks) driver (setfield (paper (), "moment_breaks", breaks), "modes", [0 3], "output", "", "solver", ...
%!                        "waveform", "tolerance", 1e-6).history;
%! [told, found] = deal (of (0.3), of ([]));
%! for [value, name] = told
%!   assert (found.(name), value);
%! endfor
