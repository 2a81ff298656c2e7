## -*- texinfo -*-
## @deftypefn {} {@var{watched} =} watched_columns (@var{name}, @var{load})
## The @var{load}, numbers or a function of one time, as a function of times (1-by-k, s) that returns its numbers in a
## column a time, with the eye of @code{watched_load} on it: an error says the @var{name} and the time.  What is empty
## comes back as it is.
## @end deftypefn

function watched = watched_columns (name, load)
  watched = load;
  if (is_function_handle (load))
    watched = @(t) columns_of (name, load, t);
  elseif (! isempty (load))
    watched = @(t) repmat (load(:), 1, numel (t));
  endif
endfunction

## in one call; one by one only to tell what is bad
function values = columns_of (name, load, t)
  try
    values = at_times (load, t);
    good = columns (values) == numel (t) && rows (values) > 0 && all (isfinite (values)(:));
  catch
    good = false;
  end_try_catch
  if (! good)
    values = one_by_one (name, watched_load (name, load), t);
  endif
endfunction

function values = one_by_one (name, watched, t)
  for k = 1:numel (t)
    value = watched (t(k))(:);
    if (isempty (value) || (k > 1 && numel (value) != rows (values)))
      error ("toolchain:integration", ...
             "%s gives %d numbers at t = %.9g, which the check of the scene did not see: mend that load\n", ...
             name, numel (value), t(k));
    endif
    values(:,k) = value;
  endfor
endfunction

%!assert (watched_columns ("force", []), [])
%!assert (watched_columns ("force", [1 2]) ([5 6 7]), [1 1 1; 2 2 2])
%!assert (watched_columns ("force", @(t) [t; 2*t]) ([5 6]), [5 6; 10 12])
%!assert (watched_columns ("value", @(t) [t 1; 2*t 3]) ([5 6]), [5 6; 10 12; 1 1; 3 3])
%!error <force gives a number that is not finite at t = 0.6, which>
%! watched_columns ("force", @(t) [1, 1/(t != 0.6)]) ([0.5 0.6 0.7])
%!error <force gives 3 numbers at t = 2, which the check>
%! watched_columns ("force", @(t) ones (1, 1 + 2*(t > 1))) ([0 2])
%!error <force gives 0 numbers at t = 1, which> watched_columns ("force", @(t) []) ([1 2])
%!function value = no_wind (t)
%!  if (t >= 0.7)
%!    error ("no wind");
%!  endif
%!  value = t;
%!endfunction
%!error <force fails at t = 0.7: no wind> watched_columns ("force", @no_wind) ([0.5 0.7])
