## -*- texinfo -*-
## @deftypefn {} {@var{good} =} are_rising (@var{numbers})
## Whether @var{numbers} are a vector of finite ones, each above the one before it, and none below 0.
## @end deftypefn

function good = are_rising (numbers)
  good = isreal (numbers) && isvector (numbers) && all (isfinite (numbers)) && all (diff (numbers) > 0) ...
         && numbers(1) >= 0;
endfunction

%!assert (are_rising ([0 0.5 3])); assert (are_rising (2))
%!assert (cellfun (@are_rising, {[1 1], [-1 2], [1 Inf], 1i, ones(2)}), false (1, 5))
