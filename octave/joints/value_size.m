## -*- texinfo -*-
## @deftypefn {} {[@var{numbers}, @var{orders}] =} value_size (@var{joint}, @var{dimension})
## How many @var{numbers} the value of a @var{joint} has (see @code{joint_kinds}), and in how many @var{orders} of
## time: 3, with its rates, where a constraint prescribes it, else 1.  A force or place has as many numbers as its
## space has @var{dimension}s (2: the plane).
## @end deftypefn

function [numbers, orders] = value_size (joint, dimension = 2)
  kind = joint_kind (joint.kind);
  numbers = kind.values;
  if (numbers == 2)
    numbers = dimension;
  endif
  orders = 1;
  if (! isempty (kind.constraints))
    orders = 3;
  endif
endfunction

%!test
%! [numbers, orders] = value_size (struct ("kind", "position"));
%! assert ([numbers, orders], [2 3]);
%! [numbers, orders] = value_size (struct ("kind", "moment"));
%! assert ([numbers, orders], [1 1]);
%!assert (cellfun (@(kind) value_size (struct ("kind", kind), 3), {"force", "moment", "spring"}), [3 1 0])
