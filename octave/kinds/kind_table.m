## -*- texinfo -*-
## @deftypefn {} {@var{kinds} =} kind_table ()
## All kinds of scenes, a row each (see @code{kind_of}): the first that has a scene takes it.  A new kind is a folder
## beside those of the others and its row here.
## @end deftypefn

function kinds = kind_table ()
  kinds = [exact_body_kind(), exact_kind(), surface_kind(), rod_kind(), curved_kind(), mechanism_kind()];
endfunction

%!test # a scene without any field is a rod's, so that what is missing gets its name
%! kinds = kind_table ();
%! assert (numel (unique ({kinds.name})), numel (kinds));
%! assert (kinds(end).has (struct ()));
