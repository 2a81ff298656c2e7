## -*- texinfo -*-
## @deftypefn {} {@var{inside} =} inside_of (@var{interval})
## The @var{interval} [start, end] (s) between two breaks without their last bits: loads are taken from inside, since
## they jump at its ends, or a bit or two beside.
## @end deftypefn

function inside = inside_of (interval)
  inside = interval + [4, -4].*eps (interval);
endfunction

%!assert (inside_of ([0.3 1]) > [0.3 0]); assert (inside_of ([0.3 1])(2) < 1)
