## -*- texinfo -*-
## @deftypefn {} {@var{failed} =} have_failed (@var{found})
## Which points of a sweep have failed (1-by-n) by what was @var{found} (see @code{gather_rows}): those with a message.
## @end deftypefn

function failed = have_failed (found)
  failed = ! cellfun (@isempty, found.message);
endfunction

%!assert (have_failed (struct ("message", {{"", "no", ""}})), [false true false])
