## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} balance_near (@var{kind}, @var{scene}, @var{model}, @var{coarse})
## The balance of forces of a checked scene's @var{model} (see @code{kind_of}), which starts at an equilibrium of a
## @var{coarse} one (a struct of balance and q; [] for none) where that one's functions are among its own; placed is
## where the scene places it.
## @end deftypefn

function balance = balance_near (kind, scene, model, coarse)
  balance = kind.at_rest (scene, model);
  balance.placed = balance.start;
  if (! isempty (coarse))
    balance.start = balance.interpolation \ (coarse.balance.interpolation*coarse.q);
  endif
endfunction

%!test # six polynomials where four are, a rod of 2 m that is stretched by 0.1 m
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1));
%! [kind, scene] = deal (surface_kind (), check_surface_scene (scene));
%! coarse.balance = balance_near (kind, scene, kind.sized (scene, 4), []);
%! assert (coarse.balance.start, zeros (8, 1));
%! coarse.q = 0.05*((1:8).' == 2);
%! fine = balance_near (kind, scene, kind.sized (scene, 6), coarse);
%! assert (fine.shape (fine.start){1}, coarse.balance.shape (coarse.q){1}, 1e-12);
%! assert (range (fine.shape (fine.start){1}(:,1)), 2.1, 1e-12);
%! assert (fine.placed, zeros (12, 1));
