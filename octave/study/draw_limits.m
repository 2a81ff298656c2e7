## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_limits (@var{curves}, @var{title}, @var{omega}, @var{scratch})
## The growth of the highest mode, of @var{omega} (rad/s), against the step, predicted and measured, as
## @code{scene_stability} has it: @var{curves} is a cell array of structs of method, limit (of h omega) and points
## (rows of h omega, predicted and measured growth a step).  Leaves stability.svg and stability.png beside the folder
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
%! [folder, gone] = scratch_folder ();
%! curves = {struct("method", "rk4", "limit", 2.83, "points", [1 1 1; 2.9 1.2 1.2]), ...
%!           struct("method", "ode23", "limit", 1.73, "points", [1 1 1; 1.8 1.2 Inf])};
%! draw = {@(scratch) draw_limits(curves, "it's a \"rod\"", 1e4, scratch)};
%! assert (draw_files (folder, draw, {"stability.svg", "stability.png"}), cell (0, 2));
%!function text = settings_of (varargin)
%!  scratch = varargin{end};
%!  finish_tool (draw_limits (varargin{:}));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # the classical method's growth from almost 0 to a tenth beyond what was measured, 1 at its limit
%! curves = {struct("method", "rk4", "limit", 2.83, "points", [1 1.5 1.25; 2.9 1.2 1.125])};
%! text = in_scratch (@(folder, scratch) settings_of (curves, "A rod", 1e4, scratch));
%! for part = {"title = 'A rod'", "array methods[1] = ['rk4']", "array limits[1] = [2.83]", "omega = 10000", ...
%!             "$measured_1 << END\n1 1.25 \n2.9 1.125 \nEND"}
%!   assert (numel (strfind (text, [part{1} "\n"])) == 1, "%s", part{1});
%! endfor
%! points = str2num (regexp (text, '\$predicted_1 << END\n(.*?)\nEND', "tokens", "once"){1});
%! assert (size (points), [200 2]); assert (points([1 end],1), [0.02; 3.19], 1e-9);
%! growth = abs (1 + 1i*points(:,1) - points(:,1).^2/2 - 1i*points(:,1).^3/6 + points(:,1).^4/24);
%! assert (points(:,2), growth, 1e-5);
