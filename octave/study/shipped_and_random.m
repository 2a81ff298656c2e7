## -*- texinfo -*-
## @deftypefn {} {@var{scenes} =} shipped_and_random (@var{plain}, @var{loaded}, @var{curved}, @var{on_surfaces})
## The names of all scenes in octave/scenes/, and so many scenes of @code{random_scene}, @code{random_loaded_scene},
## @code{random_curved_scene} and @code{random_surface_scene}, seeds 1 and on, as a cell array.
## @end deftypefn

function scenes = shipped_and_random (plain, loaded, curved, on_surfaces)
  files = glob (fullfile (fileparts (mfilename ("fullpath")), "..", "scenes", "*.m"));
  names = regexprep (files.', '.*[/\\](\w+)\.m$', '$1');
  drawn = @(draw, n) arrayfun (draw, 1:n, "uniformoutput", false);
  scenes = [names, drawn(@random_scene, plain), drawn(@random_loaded_scene, loaded), ...
            drawn(@random_curved_scene, curved), drawn(@random_surface_scene, on_surfaces)];
endfunction

%!test
%! scenes = shipped_and_random (1, 2, 1, 1);
%! assert (ismember ({"paper", "bowl", "chain", "hook"}, scenes(1:end-5)));
%! assert (cellfun (@(scene) scene.title, scenes(end-4:end), "uniformoutput", false), ...
%!         {"Random scene 1", "Random loaded scene 1", "Random loaded scene 2", "Random curved scene 1", ...
%!          "Random surface scene 1"});
