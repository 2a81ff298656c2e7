## -*- texinfo -*-
## @deftypefn {} {@var{table} =} constrained_table ()
## All integrators of mechanisms by name: a struct array of name, run (the function (system, times, start, solver) =
## [states, steps]; see @code{integrate_constrained}) and adaptive.
## @end deftypefn

function table = constrained_table ()
  rows = {
    "radau",             @integrate_radau,                                                    true
    "projection",        @(varargin) integrate_accelerations ("projection", varargin{:}),     true
    "baumgarte",         @(varargin) integrate_accelerations ("baumgarte", varargin{:}),      true
    "acceleration",      @(varargin) integrate_accelerations ("acceleration", varargin{:}),   true
    "generalized_alpha", @(varargin) integrate_constrained_steps (@index3_alpha, varargin{:}), false
    "variational",       @(varargin) integrate_constrained_steps (@variational, varargin{:}),  false
    "ode15i",            @(varargin) integrate_dae ("ode15i", varargin{:}),                   true
    "daspk",             @(varargin) integrate_dae ("daspk", varargin{:}),                    true
  };
  table = cell2struct (rows, {"name", "run", "adaptive"}, 2).';
endfunction

%!assert (numel (unique ({constrained_table().name})), 8)
