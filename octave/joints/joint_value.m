## -*- texinfo -*-
## @deftypefn {} {@var{value} =} joint_value (@var{joint}, @var{name}, @var{bodies})
## The value of a checked @var{joint} between the @var{bodies} of its scene as a function of t (1-by-k, s) that returns
## its numbers in columns, with two rates below them where a constraint prescribes them, those of each t behind those of
## the one before.  Errors call it by its @var{name}.
## @end deftypefn

function value = joint_value (joint, name, bodies)
  [numbers, orders] = value_size (joint);
  if (numbers == 0)
    values = zeros (3);
    values(1,3) = stated_angle (joint, bodies);  # a weld's tangents stay as they begin
    value = @(t) repmat (values, 1, numel (t));
  elseif (isnumeric (joint.value))
    if (numel (joint.value) != numbers && ! isequal (joint.value, 0))
      scene_error ("%s is %s: it takes %d numbers or a function of t", name, mat2str (joint.value), numbers);
    endif
    constant = zeros (orders, numbers);
    constant(1,:) = joint.value;
    value = @(t) repmat (constant, 1, numel (t));
  else
    watched = watched_columns (name, joint.value);
    value = @(t) reshape (watched (t), orders, []);
  endif
endfunction

## of the first tangent against the second, or the ground
function angle = stated_angle (joint, bodies)
  angle = tangent_of (bodies(joint.bodies(1)), joint.stations(1));
  if (joint.bodies(2) > 0)
    angle -= tangent_of (bodies(joint.bodies(2)), joint.stations(2));
  else
    angle -= joint.direction;
  endif
endfunction

function angle = tangent_of (body, station)
  angle = body.initial.phi + undeformed_angle (body, station);
endfunction

%!assert (joint_value (struct ("kind", "position", "value", [1 2]), "joints(1).value", []) (5), [1 2; 0 0; 0 0])
%!assert (joint_value (struct ("kind", "force", "value", @(t) [t 1]), "joints(1).value", []) ([5 6]), [5 1 6 1])
%!assert (joint_value (struct ("kind", "angle", "value", @(t) [t 1 0]), "joints(1).value", []) ([5 6]), [5 6; 1 1; 0 0])
%!error <joints\(1\).value is \[1 2 3\]: it takes 2 numbers or a function of t>
%! joint_value (struct ("kind", "force", "value", [1 2 3]), "joints(1).value", []);
%!error <joints\(4\).value gives a number that is not finite at t = 2>
%! joint_value (struct ("kind", "force", "value", @(t) [t NaN]), "joints(4).value", []) (2);
%!test # a weld keeps the angle at which its tangents begin, without a rate
%! body = struct ("rod", struct ("curvature", []), "model", [], "initial", struct ("phi", 1));
%! weld = struct ("kind", "weld", "bodies", [1 0], "stations", [0 0], "direction", 0.25);
%! assert (joint_value (weld, "joints(1).value", body) (5), [0 0 0.75; 0 0 0; 0 0 0]);
