## -*- texinfo -*-
## @deftypefn {} {} refuse_hosts (@var{hosts}, @var{plan})
## An error in one line where one of the @var{hosts}, "node1,2/node2,ssh -p 2222 node3" as GNU parallel's sshlogin has
## them (":" is this machine), lacks what the points of a @var{plan} (see @code{plan_sweep}) take: to be reached
## without a password, make, octave and perl, the plan's folder, the scene's file, and the same program at the same
## paths.
## @end deftypefn

function refuse_hosts (hosts, plan)
  remote = getenv ("PARALLEL_SSH");
  if (isempty (remote))
    remote = "ssh -o BatchMode=yes -o ConnectTimeout=10";
  endif
  is_new = ! isfolder (plan.folder);
  require_folder (plan.folder);
  token = make_absolute_filename (tempname (plan.folder, ".of-this-sweep-"));
  write_text (token, "");
  unwind_protect
    script = shell_string (needs (plan, token));
    for host = strtrim (strsplit (hosts, ","))
      show_progress (["looking at " host{1}]);
      login = regexprep (host{1}, '^\d+/', "");
      command = [remote " " regexprep(login, '^([^:]+):(\d+)$', '-p $2 $1') " " script];
      if (any (isspace (login)))
        command = [login " " script];
      elseif (strcmp (login, ":"))
        command = ["sh -c " script];
      endif
      [status, said] = system ([command " 2>&1 </dev/null"]);
      if (status != 0)
        scene_error ("HOSTS: %s: %s", host{1}, strtrim (strsplit (strtrim (said), "\n"){end}));
      endif
    endfor
  unwind_protect_cleanup
    show_progress ("");
    [~, ~] = unlink (token);
    if (is_new)
      [~, ~] = rmdir (plan.folder);
    endif
  end_unwind_protect
endfunction

## a script that ends well where all is there, else with a line
function script = needs (plan, token)
  root = fileparts (fileparts (which ("driver")));
  key = sprintf ("source octave/toolchain_path.m; printf (\"%%s\\n\", program_key (%d));", plan.studied);
  lines = {"for tool in make octave perl; do"
           "  command -v $tool >/dev/null || { echo $tool is not installed there; exit 1; }"
           "done"
           ["[ -w " shell_string(token) " ] ||"]
           ["  { echo the folder " shell_string(plan.folder) " of here is not there, or cannot be written; exit 1; }"]
           ["[ -r " shell_string(plan.file) " ] ||"]
           ["  { echo the scene " shell_string(plan.file) " is not there; exit 1; }"]
           ["cd " shell_string(root) " 2>/dev/null && [ \"$(octave --norc --no-gui --no-history --quiet --eval " ...
            shell_string(key) " 2>/dev/null)\" = " plan.about.program " ] ||"]
           ["  { echo the program in " shell_string(root) " is not there, or another one; exit 1; }"]};
  script = strjoin (lines, "\n");
endfunction

%!function file = stand_in (folder)   # for ssh: it runs what node1 and node2 are to run here, others are not reached
%!  file = fullfile (folder, "remote");
%!  write_text (file, ["#!/bin/sh\nhost=$1; shift\ncase $host in\n" ...
%!                     "  node1) exec sh -c \"$*\" ;;\n  node2) PATH=/nowhere exec /bin/sh -c \"$*\" ;;\n" ...
%!                     "  *) echo \"ssh: could not resolve $host\" >&2; exit 255 ;;\nesac\n"]);
%!  system (["chmod +x " file]);
%!endfunction
%!function message = of (hosts, plan)
%!  message = "";
%!  try
%!    refuse_hosts (hosts, plan);
%!  catch err
%!    message = strtrim (err.message);
%!  end_try_catch
%!  assert (! isfolder (plan.folder));
%!endfunction
%!function check (folder, scratch)
%!  unwind_protect
%!    setenv ("PARALLEL_SSH", stand_in (folder));
%!    plan = struct ("folder", fullfile (scratch, "it's"), "file", which ("swing"), "studied", false);
%!    plan.about.program = program_key ();
%!    assert (of ("4/node1, :", plan), "");
%!    assert (of ([stand_in(folder) " node1"], plan), "");
%!    assert (of ("node1,node2", plan), "HOSTS: node2: make is not installed there");
%!    assert (of ("2/node3", plan), "HOSTS: 2/node3: ssh: could not resolve node3");
%!    other = setfield (plan, "about", "program", "0");
%!    assert (strfind (of ("node1", other), "is not there, or another one") > 0);
%!    other = setfield (plan, "file", "/nowhere/rod.m");
%!    assert (of (":", other), "HOSTS: :: the scene /nowhere/rod.m is not there");
%!  unwind_protect_cleanup
%!    setenv ("PARALLEL_SSH", "");
%!  end_unwind_protect
%!endfunction
%!test in_scratch (@check);
