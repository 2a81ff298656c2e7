## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} are_forces (@var{given})
## Whether none of the joints that a scene has @var{given} (a cell array of structs, or a struct array) constrains:
## they are springs, dampers and loads (see @code{joint_kinds}).  What is no joint is left to the scene's check.
## @end deftypefn

function yes = are_forces (given)
  if (isstruct (given))
    given = num2cell (given);
  endif
  kinds = joint_kinds ();
  constrain = {kinds(! cellfun (@isempty, {kinds.constraints})).name};
  yes = iscell (given) && ! any (cellfun (@(joint) is_one_of (joint, constrain), given(:)));
endfunction

function yes = is_one_of (joint, kinds)
  yes = isstruct (joint) && isfield (joint, "kind") && any (strcmp (joint.kind, kinds));
endfunction

%!assert (are_forces ({struct("kind", "spring"), struct("kind", "force")}))
%!assert (are_forces (struct ("kind", {"bushing", "torsion_spring"})))
%!assert (! are_forces ({struct("kind", "spring"), struct("kind", "slider")}))
%!assert (are_forces ({3, struct("kind", "glue")}))
%!assert (! are_forces (3))
