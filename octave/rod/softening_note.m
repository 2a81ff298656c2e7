## -*- texinfo -*-
## @deftypefn {} {} softening_note (@var{models})
## Say that curved rods soften as they turn, whose strains are linear in their displacements, but for geometrically
## exact ones: those of the @var{models} (a cell array) that have an axis and no line.
## @end deftypefn

function softening_note (models)
  exact = @(model) isfield (model, "line") && ! isempty (model.line);
  if (any (cellfun (@(model) isfield (model.base, "axis") && ! exact (model), models)))
    say (["warning: strains of a curved rod are linear in its displacements: it softens as it turns, where it would" ...
          " stiffen; EXACT=yes, or the option \"exact\", takes the geometrically exact rod"]);
  endif
endfunction

%!test # a straight rod, a curved one, an exact one
%! model = @(base, line) struct ("base", base, "line", line);
%! said = @(model) evalc ("softening_note ({model})");
%! assert ({said(model (struct (), [])), said(model (struct ("axis", 1), 2))}, {"", ""});
%! assert (strncmp (said (model (struct ("axis", 1), [])), "warning: strains of a curved rod", 32));
