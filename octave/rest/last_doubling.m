## -*- texinfo -*-
## @deftypefn {} {[@var{metres}, @var{share}] =} last_doubling (@var{found})
## By how much the last doubling of base functions moved a place of an equilibrium that is @var{found} (see
## @code{at_rest}, whose change is that of the places, and its shape), the most, and which @var{share} that is of the
## longest way of a place from the start, or of a millionth of what places are away from O; Inf where there was no
## doubling.
## @end deftypefn

function [metres, share] = last_doubling (found)
  numbers = @(shape) vertcat (shape{:})(:).';
  places = numbers (found.shape);
  extent = max (abs (places));
  metres = max (found.change.*max (abs (places), 1e-3*extent));
  share = metres/max ([abs(places - numbers (found.balance.shape (found.balance.placed))), 1e-6*extent]);
endfunction

%!test # places [x y] of one body, 2 m from O: a thousandth of the largest stands for what is less
%! found = struct ("shape", {{[0 0; 2 0.1]}}, "change", [1 0 0 0.02]);
%! found.balance = struct ("placed", 7, "shape", @(q) {[0 0; 2 0]*q/7});
%! [metres, share] = last_doubling (found);
%! assert (metres, 0.002, 1e-15); assert (share, 0.02, 1e-14);  # of x of the first, and of y of the second
%! assert (last_doubling (setfield (found, "change", Inf (1, 4))), Inf);
%!test # what is squeezed by less than a millionth converges as well as any can see
%! found = struct ("shape", {{[0 0; 2 - 1e-8, 0]}}, "change", [0 1e-10 0 0]);
%! found.balance = struct ("placed", 1, "shape", @(q) {[0 0; 2 0]});
%! [~, share] = last_doubling (found);
%! assert (share, 1e-4, 1e-8);
