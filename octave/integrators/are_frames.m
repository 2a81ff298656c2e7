## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} are_frames (@var{system}, @var{times})
## Which of the @var{times} (1-by-m, s) of an integration are frames, or its ends: those in @var{system}.frames (1-by-k,
## s), or all where it has none.  Between frames an integrator with dense output takes no further trouble.
## @end deftypefn

function yes = are_frames (system, times)
  yes = true (size (times));
  if (isfield (system, "frames"))
    yes = ismember (times, [times([1, end]), system.frames]);
  endif
endfunction

%!assert (are_frames (struct ("n", 1), 1:3), true (1, 3))
%!assert (are_frames (struct ("frames", [0 3 9]), 1:5), logical ([1 0 1 0 1]))
