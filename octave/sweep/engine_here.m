## -*- texinfo -*-
## @deftypefn {} {[@var{engine}, @var{jobs}] =} engine_here (@var{engine}, @var{jobs})
## What distributes the points of a sweep (see @code{engine_command}), and how many run at a time, where that
## @var{engine} and so many @var{jobs} were asked for.  By default these are as many as this machine has processors,
## and with Slurm as many as it allows, Inf; "auto" is GNU parallel where it is installed and there is more than one
## job, else make.
## @end deftypefn

function [engine, jobs] = engine_here (engine, jobs)
  if (isempty (jobs))
    jobs = nproc ("current");
    if (strcmp (engine, "slurm"))
      jobs = Inf;
    endif
  endif
  if (strcmp (engine, "parallel") && ! has_parallel ())
    scene_error ("ENGINE=parallel: GNU parallel is not installed: `make setup SWEEP=yes' installs it");
  elseif (strcmp (engine, "slurm") && system ("sbatch --version >/dev/null 2>&1") != 0)
    scene_error ("ENGINE=slurm: sbatch is not here: it takes a machine from which Slurm's jobs are submitted");
  elseif (strcmp (engine, "auto"))
    engine = "make";
    if (jobs > 1 && has_parallel ())
      engine = "parallel";
    endif
  endif
endfunction

## another tool is called so, too
function yes = has_parallel ()
  yes = system ("parallel --version 2>/dev/null | grep -q '^GNU parallel'") == 0;
endfunction

%!assert (nthargout (1:2, @engine_here, "make", 8), {"make", 8})
%!assert (nthargout (1:2, @engine_here, "make", []), {"make", nproc("current")})
%!assert (engine_here ("auto", 1), "make")
%!function check (said, expected)
%!  path = getenv ("PATH");
%!  unwind_protect
%!    folder = tempname (); mkdir (folder);
%!    write_text (fullfile (folder, "parallel"), sprintf ("#!/bin/sh\necho '%s'\n", said));
%!    system (["chmod +x " fullfile(folder, "parallel")]);
%!    setenv ("PATH", [folder ":" path]);
%!    assert (engine_here ("auto", 2), expected);
%!    assert (engine_here ("parallel", 1), "parallel");
%!  unwind_protect_cleanup
%!    setenv ("PATH", path); confirm_recursive_rmdir (false, "local"); rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!test check ("GNU parallel 20221122", "parallel");
%!error <ENGINE=parallel: GNU parallel is not installed: `make setup SWEEP=yes' installs it>
%! check ("parallel of moreutils", "make");
%!function with_sbatch (status, jobs)
%!  path = getenv ("PATH");
%!  unwind_protect
%!    folder = tempname (); mkdir (folder);
%!    write_text (fullfile (folder, "sbatch"), sprintf ("#!/bin/sh\nexit %d\n", status));
%!    system (["chmod +x " fullfile(folder, "sbatch")]);
%!    setenv ("PATH", [folder ":" path]);
%!    assert (nthargout (1:2, @engine_here, "slurm", jobs), {"slurm", [jobs, Inf](1)});
%!  unwind_protect_cleanup
%!    setenv ("PATH", path); confirm_recursive_rmdir (false, "local"); rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!test with_sbatch (0, []); with_sbatch (0, 3);
%!error <ENGINE=slurm: sbatch is not here> with_sbatch (127, []);
