## -*- texinfo -*-
## @deftypefn {} {@var{joints} =} on_one_body (@var{joints})
## The @var{joints} of a scene of one rod, a cell array of structs or a struct array, as a cell array in a row: they
## are on body 1 where they do not say on which, and "joint 2" where they have no name.  What is no joint is left to
## the check (see @code{check_joints}).
## @end deftypefn

function joints = on_one_body (joints)
  if (! iscell (joints))
    joints = num2cell (joints);
  endif
  joints = joints(:).';
  for k = find (cellfun (@(joint) isstruct (joint) && isscalar (joint), joints))
    joints{k}.bodies = field_or (joints{k}, "bodies", 1);
    if (isempty (field_or (joints{k}, "name", "")))
      joints{k}.name = sprintf ("joint %d", k);
    endif
  endfor
endfunction

%!assert (on_one_body (struct ("kind", {"weld"; "force"})), ...
%!        {struct("kind", "weld", "bodies", 1, "name", "joint 1"), ...
%!         struct("kind", "force", "bodies", 1, "name", "joint 2")})
%!assert (on_one_body ({3; struct("bodies", [0 1], "name", "rail")}), {3, struct("bodies", [0 1], "name", "rail")})
%!assert (isempty (on_one_body ({})))
