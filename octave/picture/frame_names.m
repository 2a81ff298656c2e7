## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{template}] =} frame_names (@var{numbers}, @var{most})
## The files of the frames with the @var{numbers} (1-by-n) of a run that has @var{most} of them, as a cellstr:
## @file{frames/frame_0001.png} and on, with as many digits as the last one needs.  @var{template} is what makes them
## of a number, for @code{sprintf} of whatever language.
## @end deftypefn

function [names, template] = frame_names (numbers, most)
  template = sprintf ("frames/frame_%%0%dd.png", max (4, numel (sprintf ("%d", most))));
  names = arrayfun (@(number) sprintf (template, number), numbers, "UniformOutput", false);
endfunction

%!assert (frame_names ([1 91], 91), {"frames/frame_0001.png", "frames/frame_0091.png"})
%!assert (frame_names (9999, 9999), {"frames/frame_9999.png"})
%!assert (frame_names (7, 10000), {"frames/frame_00007.png"})
%!assert (nthargout (2, @frame_names, 1, 180001), "frames/frame_%06d.png")
