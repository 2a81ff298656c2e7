## -*- texinfo -*-
## @deftypefn {} {} publish_study (@var{output}, @var{numbers}, @var{pictures}, @var{write}, @var{draw}, @dots{})
## Leave what a study has found in the folder of @var{output} (see @code{take_options}), and say what is there: the
## files of @var{numbers} (cellstr), which @var{write} (folder) writes, first; then those of @var{pictures} (cellstr),
## which each @var{draw} (scratch) starts to draw, see @code{draw_files}.  A picture that cannot be made is a warning.
## Where the folder is "", nothing is left.
## @end deftypefn

function publish_study (output, numbers, pictures, write, varargin)
  if (isempty (output.folder))
    return;
  endif
  publish_run (output.folder, [pictures, numbers], write);
  names = numbers;
  if (output.pictures)
    missing = cell (0, 2);
    try
      publish_run (output.folder, pictures, @draw_all);
    catch err
      missing = [pictures(:), repmat({reason_of(err)}, numel (pictures), 1)];
    end_try_catch
    cellfun (@(text) say ("warning: %s", text), missing_warnings (missing));
    names = [names, setdiff(pictures, missing(:,1), "stable")];
  endif
  say ("%s/ has %s", output.folder, strjoin (names, ", "));

  function draw_all (aside)
    missing = draw_files (aside, varargin, pictures);
  endfunction
endfunction

%!function there = study (draw, pictures = true)   # what is there of a table and a picture, after an older picture
%!  [folder, gone] = scratch_folder ();
%!  write_text (fullfile (folder, "a.svg"), "old");
%!  write = @(folder) write_text (fullfile (folder, "a.csv"), "1\n");
%!  publish_study (struct ("folder", folder, "pictures", pictures), {"a.csv"}, {"a.svg"}, write, draw);
%!  there = setdiff ({dir(folder).name}, {".", ".."});
%!endfunction

%!test # pictures of two tools
%! draw = @(name) @(scratch) start_tool (scratch, "gnuplot", ["echo '</svg>' >../" name]);
%! [folder, gone] = scratch_folder ();
%! output = struct ("folder", folder, "pictures", true);
%! evalc ("publish_study (output, {}, {'a.svg', 'b.svg'}, @(folder) 0, draw ('a.svg'), draw ('b.svg'));");
%! assert (setdiff ({dir(folder).name}, {".", ".."}), {"a.svg", "b.svg"});
%!test # table and picture; a table alone where the tool fails, which is said, and where no picture is wanted
%! good = @(scratch) start_tool (scratch, "gnuplot", "echo '</svg>' >../a.svg");
%! bad = @(scratch) start_tool (scratch, "gnuplot", "sh -c 'echo no; exit 1'");
%! said = evalc ("there = {study(good), study(bad), study(good, false)};");
%! assert (there, {{"a.csv", "a.svg"}, {"a.csv"}, {"a.csv"}});
%! lines = strsplit (strtrim (said), "\n");
%! assert (lines{2}, "warning: a.svg is missing: gnuplot failed with status 1: no");
%! assert (! isempty (regexp (lines{1}, "/ has a.csv, a.svg$"))); assert (numel (lines), 4);
%!test # nothing
%! no = @(varargin) error ("written");
%! said = evalc ("publish_study (struct ('folder', '', 'pictures', true), {'a'}, {'b'}, no, no);");
%! assert (said, "");
