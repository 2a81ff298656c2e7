## -*- texinfo -*-
## @deftypefn {} {@var{strips} =} rod_strips (@var{history}, @var{moment})
## The panels (see @code{new_panel}) beside each frame of a hinged rod, of its @var{history} (see @code{measure}) and the
## @var{moment} at O (1-by-F, N m).
## @end deftypefn

function strips = rod_strips (history, moment)
  strips = new_panel ("φ", "°", {"φ"}, rad2deg (history.phi));
  strips(2) = new_panel ("dφ/dt", "rad/s", {"dφ/dt"}, history.phi_dot);
  strips(3) = new_panel ("M", "N m", {"M"}, moment);
endfunction

%!assert ({rod_strips(sample_history (3), [0 1 2]).label}, {"φ", "dφ/dt", "M"})
