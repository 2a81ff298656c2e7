## -*- texinfo -*-
## @deftypefn {} {@var{scenes} =} shipped_and_random (@var{plain}, @var{loaded})
## The names of all scenes in octave/scenes/, and so many scenes of @code{random_scene} and of
## @code{random_loaded_scene}, seeds 1 and on, as a cell array.
## @end deftypefn

function scenes = shipped_and_random (plain, loaded)
  files = glob (fullfile (fileparts (mfilename ("fullpath")), "..", "scenes", "*.m"));
  names = regexprep (files.', '.*[/\\](\w+)\.m$', '$1');
  drawn = @(draw, n) arrayfun (draw, 1:n, "uniformoutput", false);
  scenes = [names, drawn(@random_scene, plain), drawn(@random_loaded_scene, loaded)];
endfunction

%!test
%! scenes = shipped_and_random (1, 2);
%! assert (ismember ({"paper", "bowl", "chain", "hook"}, scenes(1:end-3)));
%! assert (cellfun (@(scene) scene.title, scenes(end-2:end), "uniformoutput", false), ...
%!         {"Random scene 1", "Random loaded scene 1", "Random loaded scene 2"});
