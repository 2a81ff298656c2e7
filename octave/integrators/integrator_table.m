## -*- texinfo -*-
## @deftypefn {} {@var{table} =} integrator_table ()
## All integrators by name: a struct array of name, run (the function (system, times, y, solver) = [states, steps]; see
## @code{integrate}), order (0: it varies) and adaptive (steps follow from the tolerance; else they are equal).
## @end deftypefn

function table = integrator_table ()
  rows = {
    "waveform",          @integrate_waveform,                                         8, true
    "exponential",       @integrate_exponential,                                      4, true
    "ode45",             @(varargin) integrate_explicit (@ode45, varargin{:}),        5, true
    "ode23",             @(varargin) integrate_explicit (@ode23, varargin{:}),        3, true
    "ode23s",            @integrate_ode23s,                                           2, true
    "ode15s",            @integrate_ode15s,                                           0, true
    "lsode_adams",       @(varargin) integrate_lsode ("adams", varargin{:}),          0, true
    "lsode_bdf",         @(varargin) integrate_lsode ("bdf", varargin{:}),            0, true
    "rk4",               @(varargin) integrate_fixed (@rk4, 4, varargin{:}),                    4, false
    "stormer_verlet",    @(varargin) integrate_fixed (@stormer_verlet, 2, varargin{:}),         2, false
    "implicit_midpoint", @(varargin) integrate_fixed (@implicit_midpoint, 2, varargin{:}),      2, false
    "generalized_alpha", @(varargin) integrate_fixed (@generalized_alpha, 2, varargin{:}),      2, false
    "trigonometric",     @(varargin) integrate_fixed (@trigonometric, 2, varargin{:}),          2, false
  };
  table = cell2struct (rows, {"name", "run", "order", "adaptive"}, 2).';
endfunction

%!test # a scene's field takes just these
%! kind = scene_fields (){strcmp(scene_fields ()(:,1), "solver.name"),3};
%! for method = integrator_table ()
%!   assert (value_error (kind, method.name), "");
%! endfor
%! assert (numel (strfind (kind, "\""))/2, numel (integrator_table ()) + 1);
