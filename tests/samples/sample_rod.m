## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{model}] =} sample_rod (@var{modes}, @var{field}, @var{value}, @dots{})
## The scene @code{paper} with so many @var{modes} ([N1 N2] sines) and with each @var{field}, as "gravity" or
## "rod.damping", of the @var{value} behind it, checked, and its model.
## @end deftypefn

function [scene, model] = sample_rod (modes, varargin)
  scene = setfield (paper (), "model", "modes", modes);
  for k = 1:2:numel (varargin)
    path = strsplit (varargin{k}, ".");
    scene = setfield (scene, path{:}, varargin{k+1});
  endfor
  scene = check_scene (scene);
  model = build_model (scene, rung_of_scene (scene));
endfunction

%!test
%! [scene, model] = sample_rod ([1 2], "gravity", 3, "rod.damping", 4);
%! assert (scene.gravity, 3); assert (scene.rod.damping, 4); assert (model.basis, eye (3));
