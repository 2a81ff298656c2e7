## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} joint_kind (@var{name})
## The row of @code{joint_kinds} that has this @var{name}, a struct.
## @end deftypefn

function kind = joint_kind (name)
  kinds = joint_kinds ();
  kind = kinds(strcmp ({kinds.name}, name));
endfunction

%!assert (joint_kind ("force").loads, [1 2])
