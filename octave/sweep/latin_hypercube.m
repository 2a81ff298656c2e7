## -*- texinfo -*-
## @deftypefn {} {@var{x} =} latin_hypercube (@var{ranges}, @var{count}, @var{seed})
## So many random points, a row each, in the @var{ranges} (a struct array of low and high), of which each of as many
## equal parts has one (McKay, Beckman and Conover 1979); the same for the same @var{seed}.
## @end deftypefn

function x = latin_hypercube (ranges, count, seed)
  x = with_seed (seed, @() drawn (ranges, count));
endfunction

function x = drawn (ranges, count)
  x = zeros (count, numel (ranges));
  for k = 1:numel (ranges)
    [~, part] = sort (rand (count, 1));
    share = (part - rand (count, 1))/count;
    x(:,k) = rounded_digits (ranges(k).low + (ranges(k).high - ranges(k).low)*share);
  endfor
endfunction

%!test # numbers that others draw afterwards are none of a sweep's
%! rand ("twister", 5); expected = rand (1, 2);
%! rand ("twister", 5); first = rand ();
%! x = latin_hypercube (struct ("low", {0, -1}, "high", {1, 1}), 4, 1);
%! assert ([first, rand()], expected);
%! assert (sort (floor (4*x(:,1))), (0:3).'); assert (sort (floor (2*x(:,2))), (-2:1).');
