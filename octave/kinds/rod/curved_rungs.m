## -*- texinfo -*-
## @deftypefn {} {@var{rungs} =} curved_rungs (@var{chosen}, @var{richer})
## The rungs of a curved rod's ladder around the @var{chosen} one: half as many longitudinal functions as bending ones,
## up to the @var{richer} rung.
## @end deftypefn

function rungs = curved_rungs (chosen, richer)
  numbers = unique ([0 1 2 3 5 8 12 18]);
  numbers = numbers(numbers < richer.sines(2)).';
  sines = unique ([floor(numbers*2/3), numbers; chosen.sines; richer.sines], "rows");
  rungs = cellfun (@(numbers) curved_rung (numbers), num2cell (sines, 2).', "uniformoutput", false);
endfunction

%!test
%! rungs = curved_rungs (curved_rung ([1 2]), curved_rung ([3 6]));
%! assert (rungs{1}, curved_rung ([0 0]));
%! assert (rungs{end}, curved_rung ([3 6]));
%! assert (cellfun (@(rung) isequal (rung.sines, [1 2]), rungs), [false false true false false false](1:numel (rungs)));
%!test # up to a far richer one
%! rungs = curved_rungs (curved_rung ([4 7]), curved_rung ([15 20]));
%! assert (cell2mat (cellfun (@(rung) rung.sines, rungs.', "uniformoutput", false)), ...
%!         [0 0; 0 1; 1 2; 2 3; 3 5; 4 7; 5 8; 8 12; 12 18; 15 20]);
%! assert (numel (curved_rungs (curved_rung ([4 7]), curved_rung ([12 18]))), 9);
