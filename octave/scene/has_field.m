## -*- texinfo -*-
## @deftypefn {} {@var{found} =} has_field (@var{given}, @var{path})
## Whether the struct @var{given} has the field at the @var{path}: its name, or @{"rod", "length"@} (a cell array).
## @end deftypefn

function found = has_field (given, path)
  found = isfield (given, path{1}) && (numel (path) == 1 || isfield (given.(path{1}), path{2}));
endfunction

%!test
%! given = struct ("duration", [], "rod", struct ("length", 1));
%! assert (has_field (given, {"duration"})); assert (has_field (given, {"rod", "length"}));
%! assert (has_field (given, {"colour"}), false); assert (has_field (given, {"rod", "colour"}), false);
%! assert (has_field (given, {"model", "modes"}), false); assert (has_field (given, {"duration", "length"}), false);
