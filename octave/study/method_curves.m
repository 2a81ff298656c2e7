## -*- texinfo -*-
## @deftypefn {} {@var{table} =} method_curves (@var{kind}, @var{scene}, @var{model}, @var{system}, @var{reference}, @
##   @var{left})
## The curves (see @code{method_curve}) of all integrators that the @var{system} of a scene's @var{model} has a form
## for, against the run @var{reference}, in @var{left} () seconds: half of them for a point of each, the other half for
## more, of the fastest first.  What a run would take, and ode45, get the most.  Points are printed as they come;
## @var{table} is a struct array of them, rows of @code{precision_point}.
## @end deftypefn

function table = method_curves (kind, scene, model, system, reference, left)
  methods = usable_methods (integrator_table (system.forms));
  weights = 1 + 3*strcmp ({methods.name}, system.auto) + 2*strcmp ({methods.name}, "ode45");
  for k = 1:numel (methods)
    seconds = max (left (), 0)/2*weights(k)/sum (weights(k:end));
    curves{k} = method_curve (kind, scene, model, methods(k), reference, seconds);
    arrayfun (@report, curves{k});
  endfor
  ran = ! cellfun (@isempty, curves);
  [curves, methods, weights] = deal (curves(ran), methods(ran), weights(ran));
  if (isempty (curves))
    error ("toolchain:integration", "no time was left for a point of any method: take a larger budget\n");
  endif
  [~, order] = sort (cellfun (@seconds_of, curves));
  for k = order
    seconds = max (left (), 0)*weights(k)/sum (weights(order(find (order == k):end)));
    known = curves{k};
    curves{k} = method_curve (kind, scene, model, methods(k), reference, seconds, known);
    arrayfun (@report, curves{k}([curves{k}.parameter] != known.parameter));
  endfor
  table = [curves{:}];
endfunction

function seconds = seconds_of (row)
  seconds = row.seconds;
  if (! isempty (row.failure))
    seconds = Inf;
  endif
endfunction

function report (row)
  note = row.failure;
  if (row.part < 1)
    note = [sprintf("(of %.2g %% of the duration) ", 100*row.part), note];
  endif
  say ("  %-18s %-7.2g %8.2g m, %8.2f s, %9d calls %s", row.method, row.parameter, row.error_m, row.seconds, ...
       row.calls, note);
  fflush (stdout);
endfunction

%!test # a point of each, of what takes the fewest seconds first another, and what failed last; 16 s are always left
%! stand_ins = {
%!   "table = usable_methods", "table", "table = table(ismember ({table.name}, {\"ode45\", \"lsode_adams\", \"rk4\"}));"
%!   "rows = method_curve", "kind, scene, model, method, takes, seconds, known = []", ["row = struct (\"method\"," ...
%!     "method.name, \"parameter\", 1, \"error_m\", seconds, \"seconds\", takes.(method.name), \"calls\", 7, \"part\"," ...
%!     " 1, \"failure\", \"\");\n" ...
%!     "if (strcmp (method.name, \"lsode_adams\")) row.failure = \"stopped\"; endif\n" ...
%!     "if (! isempty (known)) row.parameter = row.part = 0.5; endif\n" ...
%!     "rows = [known, row];"]};
%! system = struct ("forms", {{"rate"}}, "auto", "lsode_adams");
%! takes = struct ("ode45", 5, "lsode_adams", 1, "rk4", 2);
%! methods = @() printf ("%s,", {method_curves([], [], [], system, takes, @() 16).method}{:});
%! text = evalc ("with_stand_ins (stand_ins, methods);");
%! lines = strsplit (regexprep (text, ' +', " "), "\n");
%! told = {" ode45 1 3 m, 5.00 s, 7 calls "
%!         " lsode_adams 1 6.4 m, 1.00 s, 7 calls stopped"
%!         " rk4 1 8 m, 2.00 s, 7 calls "
%!         " rk4 0.5 2 m, 2.00 s, 7 calls (of 50 % of the duration) "
%!         " ode45 0.5 6.9 m, 5.00 s, 7 calls (of 50 % of the duration) "
%!         " lsode_adams 0.5 16 m, 1.00 s, 7 calls (of 50 % of the duration) stopped"};
%! assert (lines, [told.', {"ode45,ode45,lsode_adams,lsode_adams,rk4,rk4,"}]);
%!error <no time was left for a point of any method: take a larger budget>
%! kind = rod_kind ();
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.05), "model", "modes", [0 1]));
%! model = kind.build (scene, kind.stated (scene));
%! method_curves (kind, scene, model, started_system (kind, scene, model), [], @() -1);
