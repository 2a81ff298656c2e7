## -*- texinfo -*-
## @deftypefn {} {} announce_disk (@var{plan}, @var{points}, @var{frames}, @var{count}, @var{frame_size})
## Say what so many @var{points} of a @var{plan} (see @code{plan_sweep}) will take of the disk, where their runs are to
## be kept: of so many @var{frames}, with a history of some @var{count} columns, and with pictures of the
## @var{frame_size} where there are to be any.
## @end deftypefn

function announce_disk (plan, points, frames, count, frame_size)
  bytes = 3000 + 20*frames*count;
  if (plan.drawn)
    [seconds, of_pictures] = picture_cost (frames, frame_size);
    say ("PICTURES=yes: %d points of some %.2g s and %.2g MB, %.2g MB in all", points, seconds, ...
         (bytes + of_pictures)/1e6, points*(bytes + of_pictures)/1e6);
  elseif (plan.settings.keep)
    say ("KEEP=yes: %d points of some %.2g MB, %.2g MB in all", points, bytes/1e6, points*bytes/1e6);
  endif
endfunction

%!test
%! plan = struct ("drawn", false, "settings", struct ("keep", true));
%! said = @(plan) evalc ("announce_disk (plan, 400, 101, 16, [1280 720]);");
%! assert (said (plan), "KEEP=yes: 400 points of some 0.035 MB, 14 MB in all\n");
%! plan.settings.keep = false;
%! assert (said (plan), "");
%! plan.drawn = true;
%! expected = "^PICTURES=yes: 400 points of some .* s and 9.7 MB, 3.9e.03 MB in all\n$";
%! assert (! isempty (regexp (said (plan), expected)));
