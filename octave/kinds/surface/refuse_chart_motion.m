## -*- texinfo -*-
## @deftypefn {} {} refuse_chart_motion (@var{scene})
## An error where what moves the chart of a @var{scene} of a rod on a surface, the rotation of a hub or the place of an
## end, does not move a rod as a whole on that surface, or has no end to hold.
## @end deftypefn

function refuse_chart_motion (scene)
  if (! isempty (scene.rotation))
    refuse_unturned (scene);
  endif
  if (! isempty (scene.place))
    refuse_unmoved (scene);
  endif
endfunction

function refuse_unturned (scene)
  if (! any (strcmp (scene.surface.name, {"plane", "sphere"})))
    scene_error (["rotation and the surface \"%s\" are both given: a hub turns the chart about its origin, which is" ...
                  " a rotation of a \"plane\" or a \"sphere\""], scene.surface.name);
  elseif (! any (strcmp (scene.ends, "clamped")))
    scene_error ("rotation is given and no end is \"clamped\": a hub holds an end, ends = {\"clamped\", \"free\"} say");
  endif
endfunction

function refuse_unmoved (scene)
  if (! any (strcmp (scene.surface.name, {"plane", "cylinder"})))
    scene_error (["place and the surface \"%s\" are both given: it moves the chart along itself, which moves a rod as a" ...
                  " whole on a \"plane\" or a \"cylinder\""], scene.surface.name);
  elseif (all (strcmp (scene.ends, "free")))
    scene_error ("place is given and no end is held: ends = {\"hinge\", \"free\"} say which it moves");
  endif
endfunction

%!function scene = moved (surface, ends, varargin)
%!  scene = struct ("surface", struct ("name", surface, "radius", 1), "ends", {ends}, "rotation", [], "place", [], ...
%!                  varargin{:});
%!endfunction
%!error <rotation and the surface "cylinder" are both given>
%! refuse_chart_motion (moved ("cylinder", {"clamped", "free"}, "rotation", @(t) [0 0 0]));
%!error <rotation is given and no end is "clamped">
%! refuse_chart_motion (moved ("sphere", {"hinge", "free"}, "rotation", @(t) [0 0 0]));
%!error <place and the surface "sphere" are both given>
%! refuse_chart_motion (moved ("sphere", {"hinge", "free"}, "place", @(t) zeros (3, 2)));
%!error <place is given and no end is held>
%! refuse_chart_motion (moved ("cylinder", {"free", "free"}, "place", @(t) zeros (3, 2)));
%!test # what stays, and what is moved as a whole
%! refuse_chart_motion (moved ("torus", {"free", "free"}));
%! refuse_chart_motion (moved ("cylinder", {"free", "hinge"}, "place", @(t) zeros (3, 2)));
