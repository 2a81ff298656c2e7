## -*- texinfo -*-
## @deftypefn {} {@var{scenes} =} shipped_and_random (@var{n})
## The names of all scenes of the straight hinged rod in octave/scenes/ and the seeds 1 to @var{n} of
## @code{random_scene}, as a cell array.
## @end deftypefn

function scenes = shipped_and_random (n)
  files = glob (fullfile (fileparts (mfilename ("fullpath")), "..", "scenes", "*.m"));
  names = regexprep (files.', '.*[/\\](\w+)\.m$', '$1');
  scenes = [names(cellfun (@(name) is_straight (feval (name)), names)), num2cell(1:n)];
endfunction

function yes = is_straight (scene)
  yes = ! isfield (scene, "surface") && ! isfield (scene, "bodies") && ! isfield (scene.rod, "curvature");
endfunction

%!assert (any (strcmp (shipped_and_random (0), "paper")))
%!assert (shipped_and_random (2){end}, 2)
%!assert (! any (ismember ({"bowl", "chain", "hook"}, shipped_and_random (0))))
