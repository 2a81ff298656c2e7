## -*- texinfo -*-
## @deftypefn {} {@var{share} =} unopposed_share (@var{balance}, @var{t}, @var{q}, @var{lambda}, @var{step}, @
##   @var{share})
## The @var{share} of a @var{step} (n-by-1) from @var{q} that may be gone at the time @var{t} (s): halved until the
## forces of a @var{balance} (see @code{mechanism_at_rest}) along it, with the multipliers @var{lambda}, oppose it by no
## more than half of what they are at @var{q}, beyond what they oppose it there, as on the way onto constraints.
## @end deftypefn

function share = unopposed_share (balance, t, q, lambda, step, share)
  along = @(share) step.'*balance.residual (t, q + share*step, 0*q, lambda)(1:balance.n);
  pull = along (0);
  for halving = 1:20
    if (along (share) >= pull - 1.5*abs (pull))
      return;
    endif
    share /= 2;
  endfor
endfunction

%!test # past the rest of a spring by half of the way there, also by one step too long, and against a force as it is
%! balance = struct ("n", 1, "residual", @(t, q, v, lambda) t - 3*q);
%! assert (unopposed_share (balance, 6, 1, [], 1, 1), 1); assert (unopposed_share (balance, 6, 1, [], 1, 4), 1);
%! balance.residual = @(t, q, v, lambda) -2 + 0*q;
%! assert (unopposed_share (balance, 0, 1, [], 1, 1), 1);
