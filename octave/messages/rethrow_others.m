## -*- texinfo -*-
## @deftypefn {} {} rethrow_others (@var{err}, @var{identifier}, @dots{})
## Raise an error @var{err} again that has none of the identifiers, each of which stands for those below it, too:
## "toolchain:scene" (see @code{scene_error}), "toolchain:integration" and "toolchain:integration:time", a limit of
## seconds that has passed (see @code{integrate}).
## @end deftypefn

function rethrow_others (err, varargin)
  if (! any (cellfun (@(known) strncmp (err.identifier, known, numel (known)), varargin)))
    rethrow (err);
  endif
endfunction

%!function passes (id, varargin)
%!  try
%!    error (id, "no");
%!  catch err
%!    rethrow_others (err, varargin{:});
%!  end_try_catch
%!endfunction
%!test
%! passes ("toolchain:scene", "toolchain:integration", "toolchain:scene");
%! passes ("toolchain:integration:time", "toolchain:integration");
%!error id=toolchain:scene passes ("toolchain:scene", "toolchain:integration")
%!error id=toolchain:integration passes ("toolchain:integration", "toolchain:integration:time")
