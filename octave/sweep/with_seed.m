## -*- texinfo -*-
## @deftypefn {} {@var{drawn} =} with_seed (@var{seed}, @var{draw})
## What @var{draw} () makes of random numbers that begin at a @var{seed}; those of the caller go on as before.
## @end deftypefn

function drawn = with_seed (seed, draw)
  before = rand ("twister");
  unwind_protect
    rand ("twister", seed);
    drawn = draw ();
  unwind_protect_cleanup
    rand ("twister", before);
  end_unwind_protect
endfunction

%!test
%! rand ("twister", 1);
%! next = rand (1, 2);
%! rand ("twister", 1);
%! assert (rand (), next(1));
%! assert (with_seed (5, @() rand ()), with_seed (5, @() rand ()));
%! assert (rand (), next(2));
