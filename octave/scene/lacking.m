## -*- texinfo -*-
## @deftypefn {} {[@var{nothing}, @var{lacks}] =} lacking (@var{lacks})
## What a kind returns instead of a scene that it has not (see exactly in @code{kind_of}): empty, and what is lacking, a
## text.
## @end deftypefn

function [nothing, lacks] = lacking (lacks)
  nothing = [];
endfunction

%!test # for whoever asks whether there is one, and for whoever says why not
%! assert (lacking ("wings"), []);
%! [nothing, lacks] = lacking ("wings");
%! assert ({nothing, lacks}, {[], "wings"});
