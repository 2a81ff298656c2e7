## -*- texinfo -*-
## @deftypefn {} {@var{engine} =} engine_here (@var{asked}, @var{jobs})
## What distributes the points of a sweep on this machine (see @code{engine_command}): what was @var{asked} for, and
## for "auto" GNU parallel where it is installed and so many @var{jobs} are more than one, else make.
## @end deftypefn

function engine = engine_here (asked, jobs)
  engine = asked;
  if (strcmp (asked, "parallel") && ! has_parallel ())
    scene_error ("ENGINE=parallel: GNU parallel is not installed: `make setup SWEEP=yes' installs it");
  elseif (strcmp (asked, "auto"))
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

%!assert (engine_here ("make", 8), "make")
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
