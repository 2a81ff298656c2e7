## -*- texinfo -*-
## @deftypefn {} {[@var{pushed}, @var{turned}] =} stations_of_joints (@var{joints}, @var{body})
## The stations (m, rows) of a @var{body} (its number) at which checked @var{joints} bear forces, and those at which
## they bear moments; what slides along the body turns with it, and bears none.
## @end deftypefn

function [pushed, turned] = stations_of_joints (joints, body)
  pushed = turned = [];
  for joint = joints(:).'
    stations = joint.stations(joint.bodies == body);
    sees = joint_kind (joint.kind).sees;
    if (ismember ("point", sees))
      pushed = [pushed, stations];
    endif
    if (ismember ("tangent", sees) && ! strcmp (joint.kind, "slider"))
      turned = [turned, stations];
    endif
  endfor
endfunction

%!test # a weld bears both, a guide none of the moments; those of other bodies do not count
%! joint = @(kind, bodies, stations) struct ("kind", kind, "bodies", bodies, "stations", stations);
%! joints = [joint("weld", [1 2], [0 3]), joint("slider", 2, 1), joint("moment", 2, 2), joint("force", 2, 4)];
%! [pushed, turned] = stations_of_joints (joints, 2);
%! assert (pushed, [3 1 4]); assert (turned, [3 2]);
%! [pushed, turned] = stations_of_joints ([], 1);
%! assert ({pushed, turned}, {[], []});
