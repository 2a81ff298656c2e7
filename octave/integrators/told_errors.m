## -*- texinfo -*-
## @deftypefn {} {[@var{result}, @dots{}] =} told_errors (@var{call}, @var{f})
## The results of @var{call} (f), which gives the function @var{f} to one of Octave's compiled integrators.  Those say
## of an error in it that there was one: here it is raised as it was.
## @end deftypefn

function varargout = told_errors (call, f)
  raised_by (@() []);
  try
    [varargout{1:nargout}] = call (@(varargin) raised_by (f, varargin{:}));
  catch err
    raised = raised_by ();
    if (! isempty (raised))
      err = raised;
    endif
    rethrow (err);
  end_try_catch
endfunction

## a value of f; without arguments the error of the last call, or []
function value = raised_by (f, varargin)
  persistent raised = [];
  if (nargin == 0)
    value = raised;
    return;
  endif
  raised = [];
  try
    value = f (varargin{:});
  catch raised
    rethrow (raised);
  end_try_catch
endfunction

%!assert (told_errors (@(f) lsode (f, 1, [0 1]), @(y, t) -y), [1; exp(-1)], 1e-6)
%!error <the moment is lost> told_errors (@(f) lsode (f, 1, [0 1]), @(y, t) error ("the moment is lost"))
%!testif HAVE_SUNDIALS
%! run = @() told_errors (@(f) ode15s (@(t, y) f (t, y), [0 1], 1), @(t, y) error ("the moment is lost"));
%! fail ("run ()", "the moment is lost");
