## -*- texinfo -*-
## @deftypefn {} {@var{joints} =} joints_of_rod (@var{scene})
## The checked joints (see @code{check_joints}) of a @var{scene} of one rod: on the rod where they do not say on which
## body.
## @end deftypefn

function joints = joints_of_rod (scene)
  joints = scene.joints;
  if (isstruct (joints))
    joints = num2cell (joints);
  endif
  for k = find (cellfun (@(joint) isstruct (joint) && ! isfield (joint, "bodies"), joints(:).'))
    joints{k}.bodies = 1;
  endfor
  joints = check_joints (joints, scene);
endfunction

%!test
%! scene = struct ("rod", struct ("length", 2), "joints", {{struct("kind", "bushing", "stations", 1)}});
%! assert (joints_of_rod (scene).bodies, [1 0]);
