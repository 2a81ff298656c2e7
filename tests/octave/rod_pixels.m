## -*- texinfo -*-
## @deftypefn {} {@var{found} =} rod_pixels (@var{picture}, @var{place}, @var{direction})
## Where the coloured pixels of the rod lie in a @var{picture} (H-by-W-by-3), along the line through @var{place}
## ([column, row]) in the @var{direction} (a unit vector), within 14 pixels: [first, last], in pixels from the place;
## empty where there are none. Paper, axes, ghost, trail and outlines are grey.
## @end deftypefn

function found = rod_pixels (picture, place, direction)
  along = -14:0.25:14;
  column = round (place(1) + along*direction(1));
  row = round (place(2) + along*direction(2));
  colours = zeros (3, numel (along));
  for k = 1:numel (along)
    colours(:,k) = double (squeeze (picture(row(k),column(k),:)));
  endfor
  coloured = along(max (colours) - min (colours) > 40);
  found = [min(coloured), max(coloured)];
endfunction

%!function use_run (use)   # of 26 frames, in a folder that is gone afterwards
%!  [folder, gone] = scratch_folder ();
%!  scene = paper ();
%!  scene.model.modes = [0 3]; scene.duration = 0.5; scene.solver = struct ("name", "auto", "tolerance", 1e-5);
%!  evalc ("result = driver (scene, 'output', folder);");
%!  use (folder, result);
%!endfunction

%!function check_pixels (folder, result)
%!  table = csvread (fullfile (folder, "history.csv"), 1, 0);   # t, phi, phi_dot, psi, tip, V2_1, V2_2, V2_3, ...
%!  camera = fit_camera (rod_drawing (result.scene, result.model, result.history), [670 590]);
%!  column = @(x) 95 + (x - camera.x(1))/diff (camera.x)*670;   # the axes' margins in a frame of 1280 by 720
%!  row = @(y) 720 - 65 - (y - camera.y(1))/diff (camera.y)*590;
%!  for frame = [1 8 16 20 26]
%!    picture = imread (fullfile (folder, "frames", sprintf ("frame_%04d.png", frame)));
%!    phi = table(frame,2);
%!    at = @(xi) xi*exp (1i*phi) + 300i*exp (1i*phi)*(table(frame,7:9)*sin ((1:3).'*pi*xi));
%!    for xi = [0.06 0.5 0.97]
%!      tangent = at (xi + 1e-3) - at (xi - 1e-3);
%!      across = [real(1i*tangent), -imag(1i*tangent)]/abs (tangent);
%!      found = rod_pixels (picture, [column(real (at (xi))), row(imag (at (xi)))], across);
%!      assert (numel (found), 2);
%!      assert (abs (mean (found)) < 2);   # the centreline
%!      assert (diff (found)/2, 0.015/camera.pixel, 2);   # the half height
%!    endfor
%!    along = [real(tangent), -imag(tangent)]/abs (tangent);
%!    found = rod_pixels (picture, [column(real (at (1))), row(imag (at (1)))], along);
%!    assert (abs (found(2)) < 2);   # the free end
%!    found = rod_pixels (picture, [column(0), row(0)], [cos(table(frame,4)), -sin(table(frame,4))]);
%!    assert (found(1) > 0 && found(1) < 0.4*camera.symbol/camera.pixel + 2);   # the other end, from the pin on
%!  endfor
%!endfunction
%!test # the rod's pixels lie where history.csv puts the centreline
%! use_run (@check_pixels);

%!function off = difference (a, b)
%!  off = mean (abs (double (a(:)) - double (b(:))));
%!endfunction
%!function check_film (folder, result)
%!  film = fullfile (folder, "film");
%!  mkdir (film);
%!  system (sprintf ("ffmpeg -nostdin -loglevel error -i '%s/animation.mp4' '%s/%%04d.png'", folder, film));
%!  names = sort (glob (fullfile (film, "*.png")));
%!  assert (numel (names), rows (csvread (fullfile (folder, "history.csv"), 1, 0)));
%!  frame = @(k) imread (fullfile (folder, "frames", sprintf ("frame_%04d.png", k)));
%!  frames = cellfun (frame, {1, 26}, "UniformOutput", false);
%!  films = cellfun (@imread, names([1 end]), "UniformOutput", false);
%!  other = difference (frames{:});
%!  for k = 1:2
%!    assert (difference (frames{k}, films{k}) < 0.3*other);
%!  endfor
%!endfunction
%!testif ; system ("command -v ffmpeg >/dev/null") == 0 # the film has a frame a row, and its ends are the frames'
%! use_run (@check_film);
