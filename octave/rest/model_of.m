## -*- texinfo -*-
## @deftypefn {} {@var{model} =} model_of (@var{kind}, @var{scene}, @var{n})
## The model of a checked scene of a @var{kind} (see @code{kind_of}) with the modes that it states, else with @var{n}
## base functions of each sort.
## @end deftypefn

function model = model_of (kind, scene, n)
  rung = kind.stated (scene);
  if (isempty (rung))
    model = kind.sized (scene, n);
  else
    model = kind.build (scene, rung);
  endif
endfunction

%!test
%! kind = struct ("stated", @(scene) scene.modes, "sized", @(scene, n) -n, "build", @(scene, rung) rung);
%! assert (model_of (kind, struct ("modes", []), 3), -3); assert (model_of (kind, struct ("modes", 7), 3), 7);
