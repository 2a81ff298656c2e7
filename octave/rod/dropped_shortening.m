## -*- texinfo -*-
## @deftypefn {} {@var{w4} =} dropped_shortening (@var{model}, @var{stations}, @var{V})
## By how much the @var{stations} (p numbers, m) of a straight rod come nearer to O than its @var{model} with
## foreshortening has them (p-by-m, m), to the fourth order of the slope, with the amplitudes @var{V} (N-by-m).
## @end deftypefn

function w4 = dropped_shortening (model, stations, V)
  axis = dropped_points (model, struct ("tip_mass", 0, "force_station", 0)).axis;
  [along, across] = functions_at (model.base, axis.xi, 1);
  none = zeros (numel (axis.xi), columns (V));
  [~, slopes] = rod_shortening_rates (struct ("slope", across*V, "slope_dot", none, "slope_ddot", none, ...
                                              "stretch", along*V, "stretch_dot", none));
  w4 = integrals_to (axis, stations)*slopes;
endfunction

%!test # a half wave
%! [~, model] = sample_rod ([0 1]);
%! w4 = dropped_shortening (model, [0 0.5 1], [0.05 0.1]);
%! assert (w4, [0; 1.5; 3]/64*([0.05 0.1]*pi).^4, 1e-12);
