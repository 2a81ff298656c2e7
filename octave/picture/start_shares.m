## -*- texinfo -*-
## @deftypefn {} {@var{jobs} =} start_shares (@var{scratch}, @var{script}, @var{frames}, @var{frame_text})
## Draw the @var{frames} (a number) with gnuplot's @var{script} (see @code{start_gnuplot}) in the folder @var{scratch},
## in shares: each is drawn while the data of the next one are written. @var{frame_text} (frame, first) is what the
## file of a frame holds in the share that begins with the first. The frames are there when all @var{jobs} (see
## @code{finish_tool}) have ended.
## @end deftypefn

function jobs = start_shares (scratch, script, frames, frame_text)
  shares = min (2*nproc (), frames);
  for share = 1:shares
    mine = floor ((share - 1)*frames/shares) + 1:floor (share*frames/shares);
    for frame = mine
      write_text (fullfile (scratch, sprintf ("%d.gp", frame)), frame_text (frame, mine(1)));
    endfor
    jobs(share) = start_gnuplot (scratch, script, mine(1), mine(end));
  endfor
endfunction

%!function check_shares (folder, scratch)
%!  write_text (fullfile (scratch, "settings.gp"), "");
%!  jobs = start_shares (scratch, "no_such_script.gp", 7, @(frame, first) sprintf ("# %d of %d\n", frame, first));
%!  for job = jobs
%!    fail ("finish_tool (job)", "no_such_script.gp");
%!  endfor
%!  text = arrayfun (@(k) fileread (fullfile (scratch, sprintf ("%d.gp", k))), 1:7, "uniformoutput", false);
%!  first = cellfun (@(line) sscanf (line, "# %*d of %d"), text);
%!  assert (unique (first), find ([true, diff(first) > 0])); assert (numel (unique (first)), numel (jobs));
%!  assert (! isempty (regexp (fileread (fullfile (scratch, "7.gp")), "^# 7 of \\d\n$")));
%!endfunction
%!test in_scratch (@check_shares); # every frame has its file
