## -*- texinfo -*-
## @deftypefn {} {@var{text} =} chart_words (@var{table}, @var{auto}, @var{tolerance}, @var{choice}, @var{floor})
## What the @var{table} of @code{work_precision} says, in two sentences: the method that is the fastest within the
## @var{tolerance} (m), with its ratios to ode45 and to the paper's way; and what the solver "auto" takes, the method
## @var{auto} and the model of a @var{choice} (see @code{choose}; empty: the model is stated), and which of the two
## errors is the larger.
##
## Where the reference's own error, the @var{floor} (m), is above the tolerance, it takes its place.
## @end deftypefn

function text = chart_words (table, auto, tolerance, choice, floor = 0)
  within = "within the tolerance of %.2g m";
  if (floor > tolerance)
    [within, tolerance] = deal ("within %.2g m, which the reference itself may be off by,", floor);
  endif
  within = sprintf (within, tolerance);
  best = fastest_rows (table, tolerance);
  if (isempty (best))
    first = ["No method was found to be " strrep(within, ",", "") "."];
    own = [];
  else
    [~, k] = min ([best.seconds]);
    first = sprintf ("W%s the fastest is %s: %s%s.", within(2:end), best(k).method, ...
                     duration_text (best(k).seconds), slower (best, k));
    own = best(strcmp ({best.method}, auto));
  endif
  text = [first " " words_of_auto(auto, own, choice, tolerance)];
endfunction

## ratios to what takes longer: ode45 and the literal equations
function text = slower (best, k)
  text = "";
  for name = {"ode45", "literal ode45"; "ode45", "the paper's way, the literal equations by ode45,"}
    row = best(strcmp ({best.method}, name{1}));
    if (! isempty (row) && row.seconds > best(k).seconds)
      text = sprintf ("%s; %s takes %s, %s times as long", text, name{2}, duration_text (row.seconds), ...
                      two_digits (row.seconds/best(k).seconds));
    endif
  endfor
endfunction

function text = words_of_auto (auto, own, choice, tolerance)
  text = sprintf ("`auto` takes %s", auto);
  if (! isempty (own))
    text = sprintf ("%s, off by %.2g m after %s,", text, own.error_m, duration_text (own.seconds));
  endif
  if (isempty (choice))
    text = [text " and the stated model, whose own error `make models` tells."];
    return;
  endif
  row = choice.tried([choice.tried.chosen])(1);
  text = sprintf ("%s and the model of %s, off by %.2g m, %.0f %% of the tolerance", text, row.name, ...
                  choice.error_m, 100*choice.error_m/tolerance);
  if (! isempty (own))
    larger = "model";
    if (own.error_m > choice.error_m)
      larger = "integration";
    endif
    text = sprintf ("%s: the error of the %s is the larger one", text, larger);
  endif
  text = [text "."];
endfunction

function text = duration_text (seconds)
  if (seconds < 1)
    text = sprintf ("%s ms", two_digits (1000*seconds));
  elseif (seconds < 600)
    text = sprintf ("%s s", two_digits (seconds));
  elseif (seconds < 7200)
    text = sprintf ("%.0f min", seconds/60);
  else
    text = sprintf ("%.1f h", seconds/3600);
  endif
endfunction

function text = two_digits (x)
  unit = 10^(floor (log10 (max (x, realmin))) - 1);
  text = sprintf ("%.9g", round (x/unit)*unit);
endfunction

%!function table = three ()
%!  table = struct ("method", {"waveform", "waveform", "ode45", "literal ode45"}, "error_m", {1e-2 1e-4 1e-5 1e-5}, ...
%!                  "seconds", {0.01 0.05 500 5e4}, "failure", "", "part", {1 1 0.01 0});
%!endfunction
%!test
%! choice = struct ("error_m", 4e-4, "tried", struct ("name", {"rigid", "6 bending modes"}, "chosen", {false, true}));
%! text = chart_words (three (), "waveform", 1e-3, choice);
%! assert (text, ["Within the tolerance of 0.001 m the fastest is waveform: 50 ms; ode45 takes 500 s, 10000 times as " ...
%!   "long; the paper's way, the literal equations by ode45, takes 13.9 h, 1000000 times as long. `auto` takes " ...
%!   "waveform, off by 0.0001 m after 50 ms, and the model of 6 bending modes, off by 0.0004 m, 40 % of the " ...
%!   "tolerance: the error of the model is the larger one."]);
%!test # nothing that is near enough, and a stated model
%! text = chart_words (three (), "waveform", 1e-9, []);
%! assert (text, ["No method was found to be within the tolerance of 1e-09 m. " ...
%!   "`auto` takes waveform and the stated model, whose own error `make models` tells."]);
%!test # a reference that is no nearer than a hundredth of a millimetre
%! text = chart_words (three (), "waveform", 1e-9, [], 1e-5);
%! assert (strncmp (text, "Within 1e-05 m, which the reference itself may be off by, the fastest is ode45: 500 s; the", 90));
