## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} is_curved (@var{given})
## Whether the one rod of a scene, checked or not, is curved when it is not deformed.
## @end deftypefn

function yes = is_curved (given)
  yes = isfield (given, "rod") && isfield (given.rod, "curvature") && ! isempty (given.rod.curvature);
endfunction

%!assert ([is_curved(hook ()), is_curved(paper ()), is_curved(struct ("rod", 3)), is_curved(bowl ())], [true false false false])
