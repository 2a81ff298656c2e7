## -*- texinfo -*-
## @deftypefn {} {[@var{warnings}, @var{seconds}] =} draw_pictures (@var{drawing}, @var{folder})
## Frames, film and figures of @var{drawing}, written into the existing @var{folder}: @file{frames/frame_0001.png} and
## on, @file{animation.mp4}, @file{animation.gif}, @file{figure3.svg}, @file{figure3.png}, @file{figure3.pdf} and
## @file{history.svg}.
##
## The @var{drawing} of F frames has the fields @code{title}, @code{time} (1-by-F, s), @code{frames_per_second},
## @code{zoom} (the factor on the deformation in x and y), @code{gravity} (m/s²), @code{moment} (1-by-F, N m; acts at
## the first hinge, zeros for none), @code{moment_breaks} (1-by-B, s), where it is not [1280 720] @code{frame_size}
## (width and height, even numbers of pixels), and
##
## @table @code
## @item bodies
## a struct array of @code{x}, @code{y} (P-by-F, m: the centreline as drawn), @code{rest_x}, @code{rest_y} (P-by-F, m:
## the undeformed body), @code{half_height} (m), @code{stress} (P-by-F, Pa, or empty); P may differ. The end of the
## last one leaves a trail;
## @item hinges
## a struct of @code{x}, @code{y} (H-by-F, m, as drawn; H may be 0) and, where not all stand on the ground,
## @code{ground} (H-by-1, logical): others are between bodies; where not all are pins, @code{shape} (H-by-1 cellstr):
## "pin", "block" (which slides), "weld", "hub" (which turns the rod);
## @item strips
## up to four panels (see @code{new_panel}) beside each frame, whose curves a mark runs along;
## @item panels
## those of @file{history.svg}, from top to bottom;
## @item equations
## for the report: the names of the parts of its equations, @file{equations_NAME.tex} on the load path (cellstr);
## @item spectrum
## where there is one, for the foot of @file{history.svg}: a struct like that of @code{tip_spectrum};
## @item surface, backdrop
## of a rod on a surface: what is drawn in three dimensions (see @code{draw_surface_frames}), the @code{bodies} being
## what the camera sees at the start, and lines of the surface (cell array of m-by-2, m) behind those.
## @end table
##
## @var{warnings} is a cell array of texts: what could not be made, and why. @var{seconds} is a struct of how long
## @code{frames}, @code{film} and @code{figures} took.
## It is an error when the frames of the fields differ, when a value is not finite, and when gnuplot or ffmpeg fails.
## @end deftypefn

function [warnings, seconds] = draw_pictures (drawing, folder)
  check_drawing (drawing);
  of_surface = isfield (drawing, "surface");
  [figure, frames] = {@draw_figure3, @draw_frames; @draw_surface_figure, @draw_surface_frames}{1 + of_surface,:};
  scratch = @(name) fullfile (folder, ["scratch_" name]);
  cellfun (@(name) mkdir (scratch (name)), {"figure3", "history", "frames"});
  unwind_protect
    start = tic ();
    finish (frames (drawing, scratch ("frames")));
    seconds.frames = toc (start);
    made = arrayfun (@(k) sprintf ("frames/frame_%04d.png", k), 1:numel (drawing.time), "UniformOutput", false);
    require_all (folder, made);
    start = tic ();
    warnings = make_film (numel (drawing.time), film_rate (drawing.frames_per_second), folder);
    seconds.film = toc (start);
    start = tic ();
    finish ([figure(drawing, scratch ("figure3")), draw_history(drawing, scratch ("history"))]);
    require_all (folder, [strcat("figure3.", {"svg", "png", "pdf"}), {"history.svg"}]);
    seconds.figures = toc (start);
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    cellfun (@(name) rmdir (scratch (name), "s"), {"figure3", "history", "frames"});
  end_unwind_protect
endfunction

function finish (jobs)
  cellfun (@(job) finish_tool (job), num2cell (jobs));
endfunction

function require_all (folder, names)
  cellfun (@(name) require_whole (fullfile (folder, name)), names);
endfunction

%!test # every file is there, in a folder with a difficult name, and nothing else
%! folder = fullfile (tempname (), "it's a \"folder\" $HOME");
%! mkdir (fileparts (folder));
%! mkdir (folder);
%! drawing = sample_drawing (3);
%! drawing.title = "Stäbe: \"a_b\" 'c' {d} `e` \\n 100 %";
%! unwind_protect
%!   warnings = draw_pictures (drawing, folder);
%!   assert (numel (dir (fullfile (folder, "frames", "frame_000*.png"))), 3);
%!   made = {"figure3.svg", "figure3.png", "figure3.pdf", "history.svg"};
%!   if (isempty (warnings))
%!     made = [made, {"animation.mp4", "animation.gif"}];
%!   endif
%!   assert (sort ({dir(folder).name}), sort ([made, {".", "..", "frames"}]));
%! unwind_protect_cleanup
%!   confirm_recursive_rmdir (false, "local");
%!   rmdir (fileparts (folder), "s");
%! end_unwind_protect
%!error <bodies\(1\)\.y must be finite, with 2 frames>
%! drawing = sample_drawing (2);
%! drawing.bodies(1).y(1,2) = NaN;
%! draw_pictures (drawing, tempdir ());
