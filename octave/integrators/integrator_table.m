## -*- texinfo -*-
## @deftypefn {} {@var{table} =} integrator_table (@var{forms})
## All integrators, or those of systems that have the @var{forms} (a cellstr): a struct array of
##
## @table @code
## @item name
## as solver.name has it
## @item form
## of the equations that it takes: "rate" (y_dot of a state and a time), "oscillators" (the same with its linear part,
## see @code{modal_form}), "momenta", "accelerations" (see @code{momenta_of_rod}, @code{accelerations_of_rod}),
## "residual" (see @code{surface_rod}) or "constrained" (see @code{mechanism_system})
## @item run
## the function (system, times, y, solver) = [states, steps]; see @code{integrate}
## @item order
## 0: it varies
## @item adaptive
## whether steps follow from the tolerance; else they are equal
## @item share
## the part of the tolerance that a step may be off by is 1/share, so that the largest error of all frames stays near
## it: a general method has to follow every oscillation (measured on the scene `paper', tests of @code{integrate})
## @item dense
## whether states at times between system.frames (1-by-k, s, of those asked for) cost next to nothing, and nothing else
## hangs on how many there are
## @end table
## @end deftypefn

function table = integrator_table (forms)
  explicit = @(ode) @(varargin) integrate_explicit (ode, varargin{:});
  fixed = @(method) @(varargin) integrate_fixed (method, 2, varargin{:});
  lsode_of = @(method) @(varargin) integrate_lsode (method, varargin{:});
  constrained = @(method) @(varargin) constrained_states (method, varargin{:});
  index_1 = @(how) constrained (@(varargin) integrate_accelerations (how, varargin{:}));
  steps = @(method) constrained (@(varargin) integrate_constrained_steps (method, varargin{:}));
  dae = @(code) constrained (@(varargin) integrate_dae (code, varargin{:}));
  rows = {
    "waveform",          "oscillators",   @integrate_waveform,                            8, true,  1,   false
    "exponential",       "oscillators",   @integrate_exponential,                         4, true,  4,   false
    "ode45",             "rate",          explicit(@ode45),                               5, true,  400, false
    "ode23",             "rate",          explicit(@ode23),                               3, true,  400, false
    "ode23s",            "rate",          @integrate_ode23s,                              2, true,  400, false
    "ode15s",            "rate",          @integrate_ode15s,                              0, true,  400, false
    "lsode_adams",       "rate",          lsode_of("adams"),                              0, true,  400, false
    "lsode_bdf",         "rate",          lsode_of("bdf"),                                0, true,  400, false
    "rk4",               "rate",          @(varargin) integrate_fixed (@rk4, 4, varargin{:}), 4, false, 4,   false
    "stormer_verlet",    "momenta",       fixed(@stormer_verlet),                         2, false, 4,   false
    "implicit_midpoint", "momenta",       fixed(@implicit_midpoint),                      2, false, 4,   false
    "generalized_alpha", "accelerations", fixed(@generalized_alpha),                      2, false, 4,   false
    "trigonometric",     "momenta",       fixed(@trigonometric),                          2, false, 4,   false
    "generalized_alpha", "residual",      fixed(@residual_alpha),                         2, false, 4,   false
    "gauss",             "residual",      @integrate_gauss,                               8, true,  1,   true
    "radau",             "constrained",   constrained(@integrate_radau),                  9, true,  1,   true
    "radau",             "residual",      @integrate_radau_residual,                     9, true,  4,   true
    "projection",        "constrained",   index_1("projection"),                          5, true,  1,   false
    "baumgarte",         "constrained",   index_1("baumgarte"),                           5, true,  1,   false
    "acceleration",      "constrained",   index_1("acceleration"),                        5, true,  1,   false
    "generalized_alpha", "constrained",   steps(@index3_alpha),                           2, false, 1,   false
    "variational",       "constrained",   steps(@variational),                            2, false, 1,   false
    "ode15i",            "constrained",   dae("ode15i"),                                  0, true,  1,   false
    "daspk",             "constrained",   dae("daspk"),                                   0, true,  1,   false
  };
  table = cell2struct (rows, {"name", "form", "run", "order", "adaptive", "share", "dense"}, 2).';
  if (nargin > 0)
    table = table(ismember ({table.form}, forms));
  endif
endfunction

%!test # no form has a name twice, and a scene's field takes just these
%! table = integrator_table ();
%! assert (numel (unique (strcat ({table.form}, {table.name}))), numel (table));
%! kinds = {scene_fields(), {"rate", "oscillators", "momenta", "accelerations"}
%!          mechanism_fields(), {"constrained"}
%!          surface_scene_fields(), {"rate", "residual"}};
%! for kind = kinds.'
%!   takes = kind{1}{strcmp(kind{1}(:,1), "solver.name"),3};
%!   names = [{"auto"}, {integrator_table(kind{2}).name}];
%!   assert (regexp (takes, '"(\w+)"', "tokens"), num2cell (names));
%! endfor
%!test # orders as they are known, 0 where they vary; where a step's error is the run's, and where it adds up
%! known = struct ("waveform", 8, "exponential", 4, "ode45", 5, "ode23", 3, "ode23s", 2, "ode15s", 0, ...
%!   "lsode_adams", 0, ...
%!                 "lsode_bdf", 0, "rk4", 4, "stormer_verlet", 2, "implicit_midpoint", 2, "generalized_alpha", 2, ...
%!                 "trigonometric", 2, "gauss", 8, "radau", 9, "projection", 5, "baumgarte", 5, "acceleration", 5, ...
%!                 "variational", 2, "ode15i", 0, "daspk", 0);
%! for method = integrator_table ()
%!   assert (method.order, known.(method.name));
%!   assert (method.adaptive == any (strcmp (method.name, {"rk4", "stormer_verlet", "implicit_midpoint", ...
%!                                                         "generalized_alpha", "trigonometric", ...
%!                                                           "variational"})), false);
%!   if (any (strcmp (method.form, {"constrained"})) || any (strcmp (method.name, {"waveform", "gauss"})))
%!     assert (method.share, 1);
%!   elseif (strcmp (method.form, "rate") && method.adaptive)
%!     assert (method.share, 400);
%!   else
%!     assert (method.share, 4);
%!   endif
%! endfor
