## -*- texinfo -*-
## @deftypefn {} {@var{rungs} =} ladder_rungs (@var{chosen}, @var{richer})
## The rungs of a ladder of models around the @var{chosen} one: up to as many bending modes as the @var{richer} rung
## has, with and without foreshortening, then the treatments of longitudinal modes.
## @end deftypefn

function rungs = ladder_rungs (chosen, richer)
  rungs = {};
  for n = unique ([0:min(8, richer.bending), chosen.bending, richer.bending])
    for stiffening = {"none", "foreshortening"}(1:1 + (n > 0))
      rungs{end+1} = struct ("sines", [], "bending", n, "longitudinal", 0, ...
                             "axial", "none", "stiffening", stiffening{1});
    endfor
  endfor
  with = @(axial, n) setfield (setfield (chosen, "axial", axial), "longitudinal", n);
  rungs = [rungs, {with("quasistatic", 0), with("dynamic", 1), with("dynamic", 3), chosen, richer}];
  [~, first] = unique (cellfun (@rung_name, rungs, "uniformoutput", false), "first");
  rungs = rungs(sort (first));
endfunction

%!test # rigid, one mode and two, each with and without foreshortening, and longitudinal modes beside the chosen one
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 0, "axial", "none", "stiffening", "foreshortening");
%! names = cellfun (@rung_name, ladder_rungs (rung, setfield (rung, "bending", 2)), "uniformoutput", false);
%! assert (names, {"rigid", "1 bending mode", "1 bending mode, foreshortening", "2 bending modes", ...
%!                 "2 bending modes, foreshortening", ...
%!                 "1 bending mode, quasi-static longitudinal ones, foreshortening", ...
%!                 "1 bending + 1 longitudinal modes, foreshortening", ...
%!                 "1 bending + 3 longitudinal modes, foreshortening"});
%! rungs = ladder_rungs (setfield (rung, "bending", 12), setfield (rung, "bending", 20));
%! assert (unique (cellfun (@(rung) rung.bending, rungs)), [0:8, 12, 20]);
