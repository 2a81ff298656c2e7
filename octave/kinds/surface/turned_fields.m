## -*- texinfo -*-
## @deftypefn {} {@var{fields} =} turned_fields (@var{fields}, @var{moves})
## The @var{fields} of a rod's place (see @code{fields_of_basis}) in a chart that turns about its origin, in the chart
## that stands still; @var{moves} (3-by-m) has the angle (rad) and its two rates at the m times, and, where the origin
## moves (9-by-m), each of its coordinates with two rates.
## @end deftypefn

function fields = turned_fields (fields, moves)
  every = ones (rows (fields.alpha1), 1);
  turn = struct ("theta", every*moves(1,:), "theta_dot", every*moves(2,:), "theta_ddot", every*moves(3,:));
  for along = {"", "_1", "_11"}
    names = strcat ({"alpha1", "alpha2"}, along{1});
    names = [names, strcat(names, "_dot"), strcat(names, "_ddot")];
    own = cellfun (@(name) fields.(name), names, "uniformoutput", false);
    own = cell2struct (own, {"own_1", "own_2", "own_1_dot", "own_2_dot", "own_1_ddot", "own_2_ddot"}, 2);
    [values{1:6}] = chart_turned (turn, own);
    for k = 1:6
      fields.(names{k}) = values{k};
    endfor
  endfor
  if (rows (moves) == 9)
    names = {"alpha1", "alpha1_dot", "alpha1_ddot", "alpha2", "alpha2_dot", "alpha2_ddot"};
    for k = 1:6
      fields.(names{k}) += moves(3+k,:);
    endfor
  endif
endfunction

%!test # of a rod on the second axis at 2 rad/s: it goes against the first, and is drawn to the origin
%! at = struct ("values", {{1, 1}}, "slopes", {{0, 0}}, "seconds", {{0, 0}}, "start_values", {{3, 0}}, ...
%!              "start_slopes", {{1, 0}}, "start_seconds", {{0, 0}}, "kappa", 0);
%! fields = fields_of_basis (at, 0, 0, 0, [pi/2; 2; 0.5]);
%! assert ([fields.alpha1, fields.alpha2, fields.alpha1_1, fields.alpha2_1], [0 3 0 1], 1e-15);
%! assert ([fields.alpha1_dot, fields.alpha2_dot, fields.alpha1_1_dot], [-6 0 -2], 1e-14);
%! assert ([fields.alpha1_ddot, fields.alpha2_ddot], [-1.5 -12], 1e-14);
%!test # an origin that moves takes it along
%! at = struct ("values", {{1, 1}}, "slopes", {{0, 0}}, "seconds", {{0, 0}}, "start_values", {{3, 0}}, ...
%!              "start_slopes", {{1, 0}}, "start_seconds", {{0, 0}}, "kappa", 0);
%! moves = [pi/2; 2; 0.5; 10; 20; 30; 40; 50; 60];
%! [still, fields] = deal (fields_of_basis (at, 0, 0, 0, moves(1:3)), fields_of_basis (at, 0, 0, 0, moves));
%! by = @(name) fields.(name) - still.(name);
%! names = {"alpha1", "alpha1_dot", "alpha1_ddot", "alpha2", "alpha2_dot", "alpha2_ddot", "alpha1_1", "alpha2_1_dot"};
%! assert (cellfun (by, names), [10 20 30 40 50 60 0 0], 1e-14);
