## -*- texinfo -*-
## @deftypefn {} {} scene_error (@var{template}, @dots{})
## An error in one line, without a call stack: what was asked for cannot be done, and why.  Arguments as for
## @code{sprintf}.
## @end deftypefn

function scene_error (template, varargin)
  error ("toolchain:scene", "%s\n", strrep (sprintf (template, varargin{:}), "\n", " "));
endfunction

%!error <rod.length is -1> scene_error ("rod.length is %g", -1)
