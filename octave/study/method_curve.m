## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} method_curve (@var{kind}, @var{scene}, @var{model}, @var{method}, @var{reference}, @
##   @var{seconds}, @var{known})
## The curve of a @var{method} (see @code{integrator_table}) in the diagram of
## @code{work_precision}: rows of @code{precision_point} against the run @var{reference}, from coarse to fine.  Without
## rows that are @var{known} it is the point next to the scene's tolerance alone, else more points, those that tell
## most first, while the @var{seconds} last.
## @end deftypefn

function rows = method_curve (kind, scene, model, method, reference, seconds, known = struct ([]))
  parameters = 10.^[-3 -6 -9 -5 -7 -4 -8 -2];
  parameters = [10^max(floor (log10 (scene.solver.tolerance)), -9), parameters];
  if (! method.adaptive)
    parameters = 10.^[-4 -3 -5 -3.5 -4.5 -2.5 -5.5 -2 -6]*scene.duration;
  endif
  rows = known;
  spent = tic ();
  for parameter = without (parameters, known)
    left = seconds - toc (spent);
    if (left < seconds/8)
      break;
    endif
    show_progress (sprintf ("%s %.2g: %.0f s left of its %.0f s", method.name, parameter, left, seconds));
    row = precision_point (kind, scene, model, method, parameter, reference, left/(1 + ! isempty (known)), ...
                           guess (rows, parameter, method));
    if (isempty (known) || ! strncmp (row.failure, "given up after", 14))  # which is no failure of the method
      rows = [rows, row];
    endif
    if (isempty (known))
      break;
    endif
  endfor
  if (! isempty (rows))
    [~, order] = sort ([rows.parameter], "descend");
    rows = rows(order);
  endif
endfunction

function parameters = without (parameters, rows)
  parameters = unique (parameters, "stable");
  if (! isempty (rows))
    parameters = parameters(min (abs (parameters./[rows.parameter].' - 1), [], 1) > 1e-9);
  endif
endfunction

## by the point nearest: calls of equal steps by their number, the others' by a root of the tolerance
function seconds = guess (rows, parameter, method)
  seconds = NaN;
  if (! isempty (rows))
    rows = rows(cellfun (@isempty, {rows.failure}));
  endif
  if (! isempty (rows))
    [~, near] = min (abs (log ([rows.parameter]/parameter)));
    exponent = 1;
    if (method.adaptive)
      exponent = 1/8;
    endif
    seconds = rows(near).seconds*(rows(near).parameter/parameter)^exponent;
  endif
endfunction

%!test # one point, more where there is time, none twice; finer ones are nearer
%! scene = check_scene (setfield (setfield (swing (), "model", "modes", [0 0]), "duration", 0.3));
%! scene.solver.tolerance = 2e-4;
%! model = build_model (scene, rung_of_scene (scene));
%! reference = reference_run (rod_kind (), scene, model, 60);
%! of = @(name) integrator_table ()(strcmp ({integrator_table().name}, name))(1);
%! curve = @(name, varargin) method_curve (rod_kind (), scene, model, of (name), reference, varargin{:});
%! first = curve ("ode45", 60);
%! assert ([first.parameter], 1e-4, 1e-15);
%! assert (curve ("ode45", 0, first), first);
%! rows = curve ("ode45", 60, first);
%! assert ([rows.parameter], 10.^(-2:-1:-9), 1e-12);
%! assert (rows(3), first); assert ([rows.error_m] <= max ([rows.parameter], 1e-10));
%! rows = curve ("rk4", 6, curve ("rk4", 60));
%! assert (issorted ([rows.parameter], "descend")); assert (numel (rows) > 1);
%! assert (rows(1).error_m > rows(2).error_m);
%! late = setfield (rod_kind (), "system", @(varargin) error ("toolchain:integration:time", "given up after 1 s\n"));
%! point = @(known) method_curve (late, scene, model, of ("ode45"), reference, 60, known);
%! assert ({point([]).failure}, {"given up after 1 s"}); assert (point (first), first);
