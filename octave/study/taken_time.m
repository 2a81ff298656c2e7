## -*- texinfo -*-
## @deftypefn {} {[@var{time}, @var{options}] =} taken_time (@var{options}, @var{default})
## The option "time" of a study (s, not negative, or it is an error; by @var{default} 0) in a cell array of names and
## values, and the other @var{options} (see @code{taken_option}).
## @end deftypefn

function [time, options] = taken_time (options, default = 0)
  is_time = @(t) isscalar (t) && isreal (t) && isfinite (t) && t >= 0;
  [time, options] = taken_option (options, "time", default, is_time, "a time in s, not negative");
endfunction

%!test
%! [time, options] = taken_time ({"modes", [0 2], "time", 3});
%! assert (time, 3); assert (options, {"modes", [0 2]});
%! assert (taken_time ({}), 0); assert (taken_time ({}, []), []);
%!error <time is -1: it takes a time in s, not negative> taken_time ({"time", -1})
