## -*- texinfo -*-
## @deftypefn {} {@var{job} =} start_gnuplot (@var{scratch}, @var{script}, @var{first}, @var{last})
## Start gnuplot in the folder @var{scratch} on the @file{settings.gp} there and on @var{script}, a file beside this
## one, which finds the numbers of its frames in the variables first and last, and its folder in here;
## @code{finish_tool} waits for its end.
## @end deftypefn

function job = start_gnuplot (scratch, script, first = 1, last = 1)
  here = fileparts (mfilename ("fullpath"));
  scripts = cellfun (@(name) gnuplot_string (fullfile (here, name)), {"look.gp", script}, "UniformOutput", false);
  share = sprintf ("share_%d.gp", first);
  settings = struct ("first", first, "last", last, "here", [here filesep]);
  write_text (fullfile (scratch, share), [gnuplot_settings(settings), ...
                                          sprintf("load %s\n", "'settings.gp'", scripts{:})]);
  job = start_tool (scratch, "gnuplot", ["gnuplot -d " share]);
endfunction

%!function start_without_script (scratch)
%!  write_text (fullfile (scratch, "settings.gp"), "");
%!  finish_tool (start_gnuplot (scratch, "no_such_script.gp"));
%!endfunction
%!error <gnuplot failed with status 1: .*no_such_script.gp>
%! in_scratch (@(folder, scratch) start_without_script (scratch));
