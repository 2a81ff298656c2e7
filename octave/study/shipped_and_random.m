## -*- texinfo -*-
## @deftypefn {} {@var{scenes} =} shipped_and_random (@var{n})
## The names of all scenes of the hinged rod in octave/scenes/ and the seeds 1 to @var{n} of @code{random_scene}, as a
## cell array.
## @end deftypefn

function scenes = shipped_and_random (n)
  files = glob (fullfile (fileparts (mfilename ("fullpath")), "..", "scenes", "*.m"));
  names = regexprep (files.', '.*[/\\](\w+)\.m$', '$1');
  on_surface = cellfun (@(name) isfield (feval (name), "surface"), names);
  scenes = [names(! on_surface), num2cell(1:n)];
endfunction

%!assert (any (strcmp (shipped_and_random (0), "paper")))
%!assert (shipped_and_random (2){end}, 2)
%!assert (! any (strcmp (shipped_and_random (0), "bowl")))
