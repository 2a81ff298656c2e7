## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_limits (@var{curves}, @var{title}, @var{omega}, @var{scratch})
## The growth of the highest mode, of @var{omega} (rad/s), against the step, predicted and measured, as
## @code{scene_stability} has it: @var{curves} is a cell array of structs of method, limit (of h omega) and points (rows of
## h omega, predicted and measured growth a step).  Leaves stability.svg and stability.png beside the folder
## @var{scratch}, which takes the data, when @var{job} has ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_limits (curves, title, omega, scratch)
  methods = cellfun (@(curve) curve.method, curves, "uniformoutput", false);
  limits = cellfun (@(curve) curve.limit, curves);
  text = gnuplot_settings (struct ("title", title, "methods", {methods}, "limits", {num2cell(limits)}, ...
                                   "omega", omega));
  for k = 1:numel (curves)
    h_omega = linspace (0.02, 1.1*curves{k}.points(end,1), 200).';
    growth = arrayfun (@(x) predicted_growth (methods{k}, x), h_omega);
    text = [text, gnuplot_block(sprintf ("predicted_%d", k), {[h_omega, growth]}), ...
            gnuplot_block(sprintf ("measured_%d", k), {curves{k}.points(:,[1 3])})];
  endfor
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "limits.gp");
endfunction

%!test
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   curves = {struct("method", "rk4", "limit", 2.83, "points", [1 1 1; 2.9 1.2 1.2]), ...
%!             struct("method", "ode23", "limit", 1.73, "points", [1 1 1; 1.8 1.2 Inf])};
%!   draw = {@(scratch) draw_limits(curves, "it's a \"rod\"", 1e4, scratch)};
%!   assert (draw_files (folder, draw, {"stability.svg", "stability.png"}), cell (0, 2));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
