## -*- texinfo -*-
## @deftypefn {} {@var{names} =} scenes_that_choose ()
## The names (cellstr) of those in octave/scenes/ that do not state their model.
## @end deftypefn

function names = scenes_that_choose ()
  files = glob (fullfile (fileparts (which ("driver")), "scenes", "*.m"));
  names = regexprep (files.', '.*[/\\](\w+)\.m$', '$1');
  names = names(cellfun (@chooses, names));
endfunction

function yes = chooses (name)
  scene = load_scene (name);
  kind = kind_of (scene);
  yes = isempty (kind.stated (kind.check (scene)));
endfunction

%!test
%! names = scenes_that_choose ();
%! assert (ismember ({"paper", "bowl", "four_bar", "hook"}, names), true (1, 4));
%! assert (ismember ({"double_pendulum", "slider_crank"}, names), [false false]);
