## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} growing_loads (@var{scene}, @var{t})
## A checked @var{scene} whose time is a factor of its loads: forces and moments, its own and those of its joints, are
## so many times what they are at the time @var{t} (s).  Its weight stays, and what joints prescribe stays as it is
## then.  A scene without loads at that time is an error.
## @end deftypefn

function scene = growing_loads (scene, t)
  [loads, own] = acting_loads (scene);
  if (! any (cellfun (@(load) any (at_times (load, t)), loads)))
    scene_error (["the scene has no force and no moment at t = %g s that a factor could multiply: state one, or" ...
                  " another time, TIME=1 say"], t);
  endif
  for name = own
    now = at_times (scene.(name{1}), t);
    scene.(name{1}) = @(factor) kron (factor, now);
  endfor
  if (isfield (scene, "joints"))
    for k = 1:numel (scene.joints)
      now = scene.joints(k).value (t);
      scene.joints(k).value = @(factor) repmat (now, 1, numel (factor));
      if (is_load (scene.joints(k)))
        scene.joints(k).value = @(factor) kron (factor, now);
      endif
    endfor
  endif
endfunction

%!test # loads are multiplied; weight and what a joint prescribes are not
%! joints = struct ("kind", {"force", "angle"}, "value", {@(t) [t, 1], @(t) [t; 1; 0]});
%! scene = growing_loads (struct ("force", [1 2 3], "gravity", 9, "joints", joints), 3);
%! assert (scene.force (2), [2; 4; 6]); assert (scene.gravity, 9);
%! assert (scene.joints(1).value (2), [6 2]); assert (scene.joints(2).value (2), [3; 1; 0]);
%!error <no force and no moment at t = 0 s that a factor could multiply> growing_loads (struct ("moment", @(t) t), 0)
