## -*- texinfo -*-
## @deftypefn {} {@var{key} =} program_key (@var{studied})
## A hash of the sources that decide a run's numbers: those of octave/, but for scenes, pictures and, unless something
## is @var{studied}, too, studies, of generated/, and of surfaces of one's own.
## @end deftypefn

function key = program_key (studied = false)
  octave = fileparts (which ("driver"));
  others = {"scenes", "picture", "study"}(1:3-studied);
  folders = [strsplit(genpath (octave, others{:}), pathsep ()), ...
             fullfile(fileparts (octave), {"generated", fullfile("output", "surfaces")})];
  files = cellfun (@(folder) glob (fullfile (folder, "*.m")), folders, "uniformoutput", false);
  texts = cellfun (@fileread, sort (vertcat (files{:})), "uniformoutput", false);
  key = hash ("sha256", [texts{:}])(1:16);
endfunction

%!function seen = names_read (log, studied)
%!  body = sprintf ("text = ' '; id = fopen ('%s', 'a'); fprintf (id, '%%s\\n', file); fclose (id);", log);
%!  stand_in = {"text = fileread", "file", body};
%!  with_stand_ins (stand_in, @() program_key (studied));
%!  seen = regexp (fileread (log), '\w+(?=\.m$)', "match", "lineanchors");
%!endfunction
%!test # what a run takes part in it, what draws does not
%! seen = in_scratch (@(folder, scratch) names_read (fullfile (folder, "log"), false));
%! assert (ismember ({"driver", "integrate_waveform", "rod_kind", "rod_mass", "observed_value"}, seen), true (1, 5));
%! assert (ismember ({"swing", "draw_history", "write_report", "statics"}, seen), false (1, 4));
%!test # where studies are asked, they do
%! seen = in_scratch (@(folder, scratch) names_read (fullfile (folder, "log"), true));
%! assert (ismember ({"driver", "statics", "draw_history"}, seen), [true true false]);
%!test
%! assert (numel (program_key ()), 16); assert (program_key (), program_key ());
