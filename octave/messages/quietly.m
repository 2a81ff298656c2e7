## -*- texinfo -*-
## @deftypefn {} {[@var{result}, @dots{}] =} quietly (@var{f})
## The results of @var{f} (), without the warnings of Octave on the way, all of which are as they were afterwards.
## @end deftypefn

function varargout = quietly (f)
  state = warning ("off", "all");  # with "local" they do not come back
  unwind_protect
    [varargout{1:nargout}] = f ();
  unwind_protect_cleanup
    warning (state);
  end_unwind_protect
endfunction

%!test # not a word
%! assert (evalc ("assert (quietly (@() [1 2; 2 4] \\ [1; 2]), [0.2; 0.4], 1e-9);"), "");
%!test # after an error, too, what was on is on, and what was off is off
%! before = warning ();
%! fail ("quietly (@() error ('loud'))", "loud");
%! assert (isequal (warning (), before));
