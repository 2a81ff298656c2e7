## -*- texinfo -*-
## @deftypefn {} {[@var{missing}, @var{warnings}, @var{seconds}] =} draw_pictures (@var{drawing}, @var{folder})
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
## "pin", "block" (which slides), "weld", "hub" (which turns the rod), and where not all lie level, their @code{angle}
## (H-by-F, rad);
## @item springs
## where there are some: a struct of @code{x}, @code{y}, @code{to_x}, @code{to_y} (S-by-F, m, as drawn: their ends) and
## @code{shape} (S-by-1 cellstr): "coil", "spiral" (of a torsion spring);
## @item forces, moments
## where there are some, beside @code{moment}: structs of @code{x}, @code{y} (K-by-F, m, as drawn: where they act) and
## @code{F_x}, @code{F_y} (K-by-F, N), or @code{M} (K-by-F, N m);
## @item strips
## up to four panels (see @code{new_panel}) beside each frame, whose curves a mark runs along;
## @item panels
## those of @file{history.svg}, from top to bottom;
## @item panel_time
## where their times (s) are not those of the frames;
## @item notes
## where there are some: what there is to say about what is drawn (cellstr), for the summary;
## @item equations
## for the report: the names of the parts of its equations, @file{equations_NAME.tex} on the load path (cellstr);
## @item spectrum
## where there is one, for the foot of @file{history.svg}: a struct like that of @code{tip_spectrum};
## @item surface, backdrop
## of a rod on a surface: what is drawn in three dimensions (see @code{draw_surface_frames}), the @code{bodies} being
## what the camera sees at the start, and lines of the surface (cell array of m-by-2, m) behind those.
## @end table
##
## Each file, and the folder of all frames, is whole or absent: @var{missing} (n-by-2 cellstr) has each that could
## not be made, and the reason. @var{warnings} is a cell array of what else there is to say, @var{seconds} a struct of
## how long @code{frames}, @code{film} and @code{figures} took.
## It is an error when the frames of the fields differ, and when a value is not finite.
## @end deftypefn

function [missing, warnings, seconds] = draw_pictures (drawing, folder)
  check_drawing (drawing);
  confirm_recursive_rmdir (false, "local");
  figure = @draw_figure3;
  frames = @draw_frames;
  if (isfield (drawing, "surface"))
    figure = @draw_surface_figure;
    frames = @draw_surface_frames;
  endif
  start = tic ();
  number = numel (drawing.time);
  missing = draw_files (folder, {@(scratch) frames (drawing, scratch)}, frame_names (1:number, number));
  seconds.frames = toc (start);

  start = tic ();
  warnings = {};
  if (isempty (missing))
    [missing, warnings] = make_film (number, film_rate (drawing.frames_per_second), folder);
  else
    rmdir (fullfile (folder, "frames"), "s");
    missing = [{"frames"; "animation.mp4"; "animation.gif"}, missing(1,[2 2 2]).'];
  endif
  seconds.film = toc (start);

  start = tic ();
  draw = {@(scratch) figure(drawing, scratch), @(scratch) draw_history(drawing, scratch)};
  missing = [missing; draw_files(folder, draw, {"figure3.svg", "figure3.png", "figure3.pdf", "history.svg"})];
  seconds.figures = toc (start);
endfunction

%!test # every file is there, in a folder with a difficult name, and nothing else
%! [root, gone] = scratch_folder ();
%! folder = fullfile (root, "it's a \"folder\" $HOME");
%! mkdir (folder);
%! drawing = sample_drawing (3);
%! drawing.title = "Stäbe: \"a_b\" 'c' {d} `e` \\n 100 %";
%! missing = draw_pictures (drawing, folder);
%! assert (numel (dir (fullfile (folder, "frames", "frame_000*.png"))), 3);
%! made = {"figure3.svg", "figure3.png", "figure3.pdf", "history.svg", "animation.mp4", "animation.gif"};
%! made = setdiff (made, missing(:,1));  # without ffmpeg
%! assert (sort ({dir(folder).name}), sort ([made, {".", "..", "frames"}]));
%!error <bodies\(1\)\.y must be finite, with 2 frames>
%! drawing = sample_drawing (2);
%! drawing.bodies(1).y(1,2) = NaN;
%! draw_pictures (drawing, tempdir ());
%!function check_without_frames (folder)
%!  mkdir (fullfile (folder, "frames"));
%!  [missing, warnings, seconds] = draw_pictures (sample_drawing (2), folder);
%!  assert (missing, [{"frames"; "animation.mp4"; "animation.gif"; "figure3.svg"}, repmat({"no ink"}, 4, 1)]);
%!  assert (warnings, {}); assert (fieldnames (seconds), {"frames"; "film"; "figures"});
%!  assert (! isfolder (fullfile (folder, "frames")));
%!endfunction
%!test # without a frame there is no film, and the frames' folder goes
%! stand_in = {"missing = draw_files", "folder, draw, files", "missing = {files{1}, \"no ink\"};"};
%! in_scratch (@(folder, scratch) with_stand_ins (stand_in, @() check_without_frames (folder)));
