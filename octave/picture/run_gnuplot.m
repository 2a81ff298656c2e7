## -*- texinfo -*-
## @deftypefn {} {} run_gnuplot (@var{scratch}, @var{script}, @var{last})
## Run gnuplot in the folder @var{scratch} on the @file{settings.gp} there and on @var{script}, a file beside this one.
## The frames 1 to @var{last} are shared among as many processes as there are processors: each process has its own from
## the variable first to the variable last. It is an error when gnuplot fails.
## @end deftypefn

function run_gnuplot (scratch, script, last = 1)
  here = fileparts (mfilename ("fullpath"));
  scripts = cellfun (@(name) gnuplot_string (fullfile (here, name)), {"look.gp", script}, "UniformOutput", false);
  bounds = round (linspace (0, last, min (nproc (), last) + 1));
  for share = 1:numel (bounds) - 1
    write_text (fullfile (scratch, sprintf ("share_%d.gp", share)),
                [gnuplot_settings(struct ("first", bounds(share) + 1, "last", bounds(share+1))), ...
                 sprintf("load %s\n", "'settings.gp'", scripts{:})]);
  endfor
  run_tool (scratch, "gnuplot", "ls share_*.gp | xargs -n 1 -P 0 gnuplot");
  delete (fullfile (scratch, "share_*.gp"));
endfunction

%!error <gnuplot failed with status 123: .*no_such_script.gp>
%! scratch = tempname ();
%! mkdir (scratch);
%! unwind_protect
%!   write_text (fullfile (scratch, "settings.gp"), "");
%!   run_gnuplot (scratch, "no_such_script.gp");
%! unwind_protect_cleanup
%!   confirm_recursive_rmdir (false, "local");
%!   rmdir (scratch, "s");
%! end_unwind_protect
