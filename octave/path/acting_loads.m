## -*- texinfo -*-
## @deftypefn {} {[@var{loads}, @var{own}] =} acting_loads (@var{scene})
## The forces and moments of a checked @var{scene} and of its joints, a cell array of numbers and functions of t (see
## @code{at_times}); its weight, and what joints prescribe, is none of them.  @var{own} (cellstr, 1-by-k) are the
## fields of the first of them, the scene's own.
## @end deftypefn

function [loads, own] = acting_loads (scene)
  own = intersect ({"moment", "tip_moment", "force"}, fieldnames (scene).');
  loads = cellfun (@(name) scene.(name), own, "uniformoutput", false);
  if (isfield (scene, "joints"))
    loads = [loads, {scene.joints(is_load (scene.joints)).value}];
  endif
endfunction

%!test
%! joints = struct ("kind", {"weld", "force"}, "value", {@(t) 0, @(t) [t 1]});
%! [loads, own] = acting_loads (struct ("gravity", 9.81, "moment", 3, "joints", joints));
%! assert (loads{1}, 3); assert (loads{2} (5), [5 1]); assert (numel (loads), 2); assert (own, {"moment"});
