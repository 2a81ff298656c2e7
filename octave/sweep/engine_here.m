## -*- texinfo -*-
## @deftypefn {} {[@var{engine}, @var{jobs}] =} engine_here (@var{settings})
## What distributes the points of a sweep (see @code{engine_command}), and how many run at a time, where the
## @var{settings} (see @code{sweep_settings}) have an engine, jobs, hosts and limits.  By default these are as many as
## this machine has processors, and with Slurm or on hosts as many as they allow, Inf; "auto" is GNU parallel where it
## is installed and there is more than one job, else make.
## @end deftypefn

function [engine, jobs] = engine_here (settings)
  [engine, jobs] = deal (settings.engine, settings.jobs);
  if (! isempty (settings.hosts) && strcmp (engine, "auto"))
    engine = "parallel";
  endif
  if (isempty (jobs))
    jobs = nproc ("current");
    if (strcmp (engine, "slurm") || ! isempty (settings.hosts))
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
  refuse_others (settings, engine);
endfunction

## what is asked of an engine that cannot have it
function refuse_others (settings, engine)
  takers = struct ("hosts", {{"parallel"}}, "load", {{"parallel", "make"}}, "memory", {{"parallel", "slurm"}});
  for [engines, name] = takers
    if (! isempty (settings.(name)) && ! any (strcmp (engine, engines)))
      scene_error ("%s takes ENGINE=%s, and this is %s", toupper (name), strjoin (engines, " or "), engine);
    endif
  endfor
  if (! isempty (settings.memory) && isempty (regexp (settings.memory, '^[1-9]\d*[KMGT]$', "once")))
    scene_error ("memory is %s: it takes a whole number and K, M, G or T, as in MEMORY=2G", settings.memory);
  endif
endfunction

## another tool is called so, too
function yes = has_parallel ()
  yes = system ("parallel --version 2>/dev/null | grep -q '^GNU parallel'") == 0;
endfunction

%!function [engine, jobs] = of (engine, jobs, varargin)
%!  settings = take_settings ([{"engine", engine, "jobs", jobs}, varargin]);
%!  [engine, jobs] = engine_here (settings);
%!endfunction
%!assert (nthargout (1:2, @of, "make", 8), {"make", 8})
%!assert (nthargout (1:2, @of, "make", []), {"make", nproc("current")})
%!assert (of ("auto", 1), "make")
%!error <HOSTS takes ENGINE=parallel, and this is make> of ("make", 2, "hosts", "a")
%!error <MEMORY takes ENGINE=parallel or slurm, and this is make> of ("make", 2, "memory", "2G")
%!function check (said, expected)
%!  path = getenv ("PATH"); [folder, gone] = scratch_folder ();
%!  unwind_protect
%!    write_text (fullfile (folder, "parallel"), sprintf ("#!/bin/sh\necho '%s'\n", said));
%!    system (["chmod +x " fullfile(folder, "parallel")]);
%!    setenv ("PATH", [folder ":" path]);
%!    assert (of ("auto", 2), expected);
%!    assert (of ("parallel", 1), "parallel");
%!    assert (nthargout (1:2, @of, "auto", [], "hosts", "a"), {"parallel", Inf});
%!    fail ("of ('parallel', 1, 'memory', '2 G')", "memory is 2 G: it takes a whole number and K, M, G or T");
%!  unwind_protect_cleanup
%!    setenv ("PATH", path);
%!  end_unwind_protect
%!endfunction
%!test check ("GNU parallel 20221122", "parallel");
%!error <ENGINE=parallel: GNU parallel is not installed: `make setup SWEEP=yes' installs it>
%! check ("parallel of moreutils", "make");
%!function with_sbatch (status, jobs)
%!  path = getenv ("PATH"); [folder, gone] = scratch_folder ();
%!  unwind_protect
%!    write_text (fullfile (folder, "sbatch"), sprintf ("#!/bin/sh\nexit %d\n", status));
%!    system (["chmod +x " fullfile(folder, "sbatch")]);
%!    setenv ("PATH", [folder ":" path]);
%!    assert (nthargout (1:2, @of, "slurm", jobs), {"slurm", [jobs, Inf](1)});
%!  unwind_protect_cleanup
%!    setenv ("PATH", path);
%!  end_unwind_protect
%!endfunction
%!test with_sbatch (0, []); with_sbatch (0, 3);
%!error <ENGINE=slurm: sbatch is not here> with_sbatch (127, []);
