## -*- texinfo -*-
## @deftypefn {} {@var{missing} =} draw_files (@var{folder}, @var{draw}, @var{files})
## Let each of the functions @var{draw} (cell array) start the jobs that draw the @var{files} (cellstr) in the
## @var{folder}: it takes a folder of its own for its data, beside the files, and returns jobs (see @code{start_tool}).
## @var{missing} (n-by-2 cellstr) has each file that then is not there, or was not whole and is removed, and the
## reason.
## @end deftypefn

function missing = draw_files (folder, draw, files)
  confirm_recursive_rmdir (false, "local");
  scratch = arrayfun (@(k) fullfile (folder, sprintf ("scratch_%d", k)), 1:numel (draw), "UniformOutput", false);
  cellfun (@(name) mkdir (name), scratch);
  reason = "cannot be written whole: is the disk full?";  # gnuplot ends well where it is
  unwind_protect
    try
      jobs = cellfun (@(draw, scratch) draw (scratch), draw, scratch, "UniformOutput", false);
      finish_tools ([jobs{:}]);
    catch err
      reason = reason_of (err);
    end_try_catch
  unwind_protect_cleanup
    cellfun (@(name) rmdir (name, "s"), scratch);
  end_unwind_protect
  missing = cell (0, 2);
  for name = files
    file = fullfile (folder, name{1});
    if (! is_whole (file))
      [~, ~] = unlink (file);
      missing(end+1,:) = {name{1}, reason};
    endif
  endfor
endfunction

%!function found = drawn_in (folder, draw, files)   # what is missing of the files, and what is there
%!  missing = draw_files (folder, draw, files);
%!  found = {missing(:,1).', missing(:,2).', setdiff({dir(folder).name}, {".", "..", "scratch"})};
%!endfunction
%!function found = drawn (draw, files)
%!  found = in_scratch (@(folder, scratch) drawn_in (folder, draw, files));
%!endfunction
%!function job = svg (scratch, text)
%!  job = start_tool (scratch, "gnuplot", ["echo '" text "' > ../a.svg; echo '<svg>' > ../b.svg"]);
%!endfunction
%!function job = on_full_disk (scratch)
%!  write_text ("/dev/full", repmat ("text", 1, 1e5));
%!endfunction

%!assert (drawn ({@(scratch) svg(scratch, "</svg>")}, {"a.svg"}){1}, cell (1, 0))
%!test # what is not whole goes, what is stays; the tool's own last line is the reason
%! found = drawn ({@(scratch) svg(scratch, "</svg>")}, {"a.svg", "b.svg"});
%! assert (found, {{"b.svg"}, {"cannot be written whole: is the disk full?"}, {"a.svg"}});
%! failed = @(scratch) start_tool (scratch, "gnuplot", "sh -c 'echo no font; exit 1'");
%! found = drawn ({failed, @(scratch) svg(scratch, "</svg>")}, {"a.svg", "b.svg"});
%! assert (found, {{"b.svg"}, {"gnuplot failed with status 1: no font"}, {"a.svg"}});
%!test # data that cannot be written
%! found = drawn ({@on_full_disk}, {"a.svg"});
%! assert (found{2}, {"cannot be written whole: is the disk full?"});
