## -*- texinfo -*-
## @deftypefn {} {@var{key} =} program_key ()
## A hash of the sources that decide a run's numbers: those of octave/, but for scenes, pictures and studies, and of
## generated/.
## @end deftypefn

function key = program_key ()
  octave = fileparts (which ("driver"));
  folders = [strsplit(genpath (octave, "scenes", "picture", "study"), pathsep ()), ...
             {fullfile(fileparts (octave), "generated")}];
  files = cellfun (@(folder) glob (fullfile (folder, "*.m")), folders, "uniformoutput", false);
  texts = cellfun (@fileread, sort (vertcat (files{:})), "uniformoutput", false);
  key = hash ("sha256", [texts{:}])(1:16);
endfunction

%!function seen = names_read (log)
%!  body = sprintf ("text = ' '; id = fopen ('%s', 'a'); fprintf (id, '%%s\\n', file); fclose (id);", log);
%!  stand_in = {"text = fileread", "file", body};
%!  with_stand_ins (stand_in, @() program_key ());
%!  seen = regexp (fileread (log), '\w+(?=\.m$)', "match", "lineanchors");
%!endfunction
%!test # what a run takes part in it, what draws does not
%! seen = in_scratch (@(folder, scratch) names_read (fullfile (folder, "log")));
%! assert (ismember ({"driver", "integrate_waveform", "rod_kind", "rod_mass", "observed_value"}, seen), true (1, 5));
%! assert (ismember ({"swing", "draw_history", "write_report", "statics"}, seen), false (1, 4));
%!test
%! assert (numel (program_key ()), 16); assert (program_key (), program_key ());
