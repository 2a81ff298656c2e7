## -*- texinfo -*-
## @deftypefn {} {[@var{others}, @var{own}] =} foreign_files (@var{folder}, @var{pattern})
## The names of what is in the @var{folder}, none where there is no such, as two cellstr: @var{own} are those like the
## @var{pattern}, in which * stands for digits, @var{others} are not.
## @end deftypefn

function [others, own] = foreign_files (folder, pattern)
  names = {};
  if (isfolder (folder))
    names = setdiff (readdir (folder).', {".", ".."});
  endif
  like = ["^" strrep(regexptranslate ("escape", pattern), '\*', '\d+') "$"];
  is_own = ! cellfun (@isempty, regexp (names, like, "once"));
  own = names(is_own);
  others = names(! is_own);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! cellfun (@(name) write_text (fullfile (folder, name), "1"), {"frame_0001.png", "frame_a.png", "frame_12.png"});
%! [others, own] = foreign_files (folder, "frame_*.png");
%! assert (others, {"frame_a.png"}); assert (own, {"frame_0001.png", "frame_12.png"});
%! assert (isempty (foreign_files (fullfile (folder, "none"), "a")));
