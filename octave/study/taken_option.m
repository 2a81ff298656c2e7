## -*- texinfo -*-
## @deftypefn {} {[@var{value}, @var{options}] =} taken_option (@var{options}, @var{name}, @var{default}, @var{is_good}, @
##   @var{takes})
## The last @var{value} of an option in a cell array of names and values, numbers for which @var{is_good} is true (else
## an error says that it @var{takes} something else), or its @var{default}; and the other @var{options}.
## @end deftypefn

function [value, options] = taken_option (options, name, default, is_good, takes)
  value = default;
  [options, taken] = without_options (options, name);
  if (! isempty (taken))
    value = taken{end};
    if (! (isnumeric (value) && ! isempty (value) && is_good (value)))
      scene_error ("%s is %s: it takes %s", name, strtrim (disp (value)), takes);
    endif
  endif
endfunction

%!test
%! [value, options] = taken_option ({"modes", 3, "time", 2, "output", "x"}, "time", 0, @(t) t > 0, "more than 0");
%! assert (value, 2); assert (options, {"modes", 3, "output", "x"});
%! [value, options] = taken_option ({"modes", 3}, "time", 7, @(t) t > 0, "more than 0");
%! assert (value, 7); assert (options, {"modes", 3});
%!error <time is 0: it takes more than 0> taken_option ({"time", 0}, "time", 1, @(t) t > 0, "more than 0");
%!error <time is soon: it takes more than 0> taken_option ({"time", "soon"}, "time", 1, @(t) t > 0, "more than 0");
