## -*- texinfo -*-
## @deftypefn {} {[@var{others}, @var{taken}] =} without_options (@var{options}, @var{names})
## The options of a cell array of names and values but for those of the @var{names} (text, or cellstr), and these: what
## is @var{taken} has a column of name and value each.
## @end deftypefn

function [others, taken] = without_options (options, names)
  at = 2*find (cellfun (@(name) any (strcmp (name, names)), options(1:2:end-1)))(:).';
  pairs = [at - 1; at];
  taken = reshape (options(pairs), 2, []);
  others = options;
  others(pairs) = [];
endfunction

%!test
%! [others, taken] = without_options ({"a", 1, "b", {}, "a", "c"}, "a");
%! assert (others, {"b", {}}); assert (taken, {"a", "a"; 1, "c"});
%! [others, taken] = without_options ({"a", 1, "b", "a"}, {"b", "c"});
%! assert (others, {"a", 1}); assert (taken, {"b"; "a"});
%!test # of none; a name that is no text, or has no value, is nobody's
%! [others, taken] = without_options ({}, {"a"});
%! assert (isempty (others) && iscell (others)); assert (isempty (taken));
%! assert (without_options ({7, 1, "a"}, "a"), {7, 1, "a"});
