## -*- texinfo -*-
## @deftypefn {} {@var{reason} =} reason_of (@var{err})
## Why a picture could not be made: the message of an error @var{err}, and of a file that could not be written whole
## nothing but that, since it lay aside.
## @end deftypefn

function reason = reason_of (err)
  reason = strtrim (regexprep (err.message, '^.* (cannot be written whole)', "$1"));
endfunction

%!assert (reason_of (struct ("message", "gnuplot failed\n")), "gnuplot failed")
%!error <^cannot be written whole: is the disk full\?$>
%! try, write_text ("/dev/full", repmat ("text", 1, 1e5)); catch err, error (reason_of (err)); end_try_catch
