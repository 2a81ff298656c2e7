## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} random_drawing (@var{seed}, @var{drawing})
## A @var{drawing} (see @code{draw_pictures}) with titles, names and values that users and runs may come up with, drawn
## at random: quotes, backslashes, braces, percent signs, newlines, all letters; zeros, constants, values near the ends
## of what a number can be.
## @end deftypefn

function drawing = random_drawing (seed, drawing)
  rand ("twister", seed);
  randn ("twister", seed);
  drawing.title = random_text ();
  drawing.zoom *= pick ({1, 1e-9, 1e9});
  drawing.frame_size = pick ({[320 320], [640 360], [360 640]});
  for list = {"strips", "panels"}
    for i = 1:numel (drawing.(list{1}))
      panel = drawing.(list{1})(i);
      panel.names = cellfun (@(name) random_text (), panel.names, "UniformOutput", false);
      panel.label = pick ({panel.label, random_text()});
      panel.values = random_values (size (panel.values));
      drawing.(list{1})(i) = panel;
    endfor
  endfor
  drawing.moment = random_values (size (drawing.moment));
  for k = 1:numel (drawing.bodies)
    if (! isempty (drawing.bodies(k).stress))
      drawing.bodies(k).stress = abs (random_values (size (drawing.bodies(k).stress)));
    endif
  endfor
endfunction

function text = random_text ()
  parts = {"a", "Stab", "it's", "\"", "''", "\\", "\\n", "\n", "\t", "{", "}", "{/Symbol a}", "%", "%s", "%d", ...
           "$x", "`date`", "@", "^", "_", "&", "~", "#", ";", ",", " ", "[1]", "ž", "φ̇", ...
           "日本", "😀", "<b>", "--", "END"};
  text = ["" parts{randi(numel (parts), 1, pick ({0, 1, 3, 8, 60}))}];
endfunction

function values = random_values (sizes)
  scale = pick ({0, -0, 5e-324, 1e-320, 1e-300, 1e-30, 1, 1e9, 1e30, 1e300, realmax});
  values = pick ({scale*ones(sizes), scale*(2*rand (sizes) - 1), cumsum(ones (sizes), 2)*(scale/sizes(2)), ...
                  1 + scale*rand(sizes)/realmax});
endfunction

function choice = pick (choices)
  choice = choices{randi(numel (choices))};
endfunction

%!function scripts_run (seed)
%!  flat = random_drawing (seed, {@sample_drawing, @sample_bodies}{1 + mod(seed, 2)}(2));
%!  curved = random_drawing (seed, sample_surface (2));
%!  figures = {"figure3.svg", "figure3.png", "figure3.pdf"};
%!  for row = {@draw_frames, flat, frame_names(1:2, 2); @draw_figure3, flat, figures; ...
%!             @draw_history, flat, {"history.svg"}; @draw_surface_frames, curved, frame_names(1:2, 2); ...
%!             @draw_surface_figure, curved, figures}.'
%!    [folder, gone] = scratch_folder ();
%!    missing = draw_files (folder, {@(scratch) row{1}(row{2}, scratch)}, row{3});
%!    assert (missing, cell (0, 2), sprintf ("seed %d, %s: %s", seed, func2str (row{1}), [missing.'{:}]));
%!  endfor
%!endfunction

%!test # gnuplot takes whatever comes
%! for seed = [2 8 12 19]
%!   scripts_run (seed);
%! endfor
