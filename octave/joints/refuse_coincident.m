## -*- texinfo -*-
## @deftypefn {} {} refuse_coincident (@var{joints}, @var{mechanism}, @var{markers})
## An error that names a spring among the @var{joints} whose points coincide where the @var{markers} of the
## @var{mechanism} (see @code{marker_motion}) are: its force is along the line through them.
## @end deftypefn

function refuse_coincident (joints, mechanism, markers)
  is_spring = strcmp ({joints.kind}, "spring")(:).';  # Octave 11 goes once through a column of none
  for j = find (is_spring)
    pair = mechanism.marker_of(j,:);
    apart = hypot (diff (markers.x(pair)), diff (markers.y(pair)));
    group = mechanism.markers(arrayfun (@(group) any (group.numbers == pair(1)), mechanism.markers)).group;
    if (apart <= 1e-9*mechanism.groups(group).model.length)
      scene_error (["%s: the points of the spring coincide at the start, so that its force has no direction: take a" ...
                    " bushing, which holds two points together, or another place"], joints(j).name);
    endif
  endfor
endfunction

%!error <joint 1: the points of the spring coincide at the start, so that its force has no direction: take a>
%! [scene, model] = sample_rod ([0 1], "joints", struct ("kind", "spring", "stations", 0.5, "point", [0.5 0]), ...
%!                              "initial.phi", 0);
%! rod_system (scene, model);
