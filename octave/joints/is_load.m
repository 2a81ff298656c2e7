## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} is_load (@var{joints})
## Which of the checked @var{joints} are loads, "force" and "moment": 1-by-k, a truth value a joint.  The others
## constrain, or are springs and dampers.
## @end deftypefn

function yes = is_load (joints)
  yes = ! arrayfun (@(joint) isempty (joint_kind (joint.kind).loads), joints(:).');
endfunction

%!assert (is_load (struct ("kind", {"weld", "force", "spring", "moment", "angle"})), logical ([0 1 0 1 0]))
%!assert (is_load (struct ("kind", {})), logical (zeros (1, 0)))
