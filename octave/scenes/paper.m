## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} paper ()
## The paper's rod (section VIII): hinged at O, 30 degrees below the horizontal, at rest; a moment grows for 0.3 s and
## stops at 90 N m; the rod swings up to 34 degrees, back and past the lowest point.  The paper gives neither l, w nor
## h: see README.
## @end deftypefn

function scene = paper ()
  scene.title = "Elastic rod driven by a moment, Mareš and Štefan (2010)";
  scene.rod.length = 1;
  scene.rod.width = 0.02;
  scene.rod.half_height = 0.015;
  scene.rod.lambda = 1.2e11;
  scene.rod.mu = 8.1e10;
  scene.rod.density = 7800;
  scene.moment = @(t) 300*t.*(t < 0.3);
  scene.moment_breaks = 0.3;
  scene.initial.phi = -pi/6;
  scene.duration = 1.8;
  scene.zoom = 300;
endfunction

%!test # the moment stops at 0.3 s
%! assert (paper ().moment ([0 0.1 0.3 1]), [0 30 0 0], 1e-12);
