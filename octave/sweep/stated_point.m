## -*- texinfo -*-
## @deftypefn {} {[@var{columns}, @var{values}] =} stated_point (@var{settings})
## The one point that @var{settings} state (see @code{sweep_settings}), as @code{sweep_table} has points: that of AT,
## and without it no columns, the scene as it is.
## @end deftypefn

function [columns, values] = stated_point (settings)
  tables = {"vary", "zip", "over", "table"};
  stated = tables(! cellfun (@(name) isempty (settings.(name)), tables));
  if (! isempty (stated))
    scene_error ("%s is of a sweep: one point takes AT, as in AT=\"rod.length=0.2\"", toupper (stated{1}));
  endif
  columns = values = {};
  if (! isempty (settings.at))
    [columns, values] = sweep_table (settings);
  endif
endfunction

%!function [columns, values] = point (varargin)
%!  [columns, values] = stated_point (take_settings (varargin));
%!endfunction
%!assert (nthargout (1:2, @point, "at", "a=1; b=0 4"), {{"a", "b"}, {1, [0 4]}})
%!assert (nthargout (1:2, @point), {{}, {}})
%!error <VARY is of a sweep: one point takes AT, as in AT="rod.length=0.2"> point ("vary", "a=1")
