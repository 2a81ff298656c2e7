## -*- texinfo -*-
## @deftypefn {} {@var{note} =} stiffening_note (@var{models}, @var{bending})
## What became of model.stiffening = "auto" of rods with these @var{models}, a struct array of a scene's fields model,
## and stated numbers of @var{bending} modes (0 where they are chosen): numbers of modes are the paper's model, which
## has none.  Empty where no such rod bends.
## @end deftypefn

function note = stiffening_note (models, bending)
  note = "";
  if (any (strcmp ({models.stiffening}, "auto") & bending > 0))
    note = "stiffening = \"auto\" is none where numbers of modes are stated";
  endif
endfunction

%!test
%! models = struct ("stiffening", {"auto", "foreshortening", "none"});
%! assert (stiffening_note (models, [0 7 7]), "");
%! assert (stiffening_note (models, [7 7 7]), "stiffening = \"auto\" is none where numbers of modes are stated");
