## -*- texinfo -*-
## @deftypefn {} {@var{width} =} text_width (@var{text})
## How wide @var{text} is, about, in units of a frame (see @code{frame_layout}), set in the frames' size.
## @end deftypefn

function width = text_width (text)
  narrow = sum (ismember (text, " .,-:;'|()[]fijlrtI1"));
  wide = sum (ismember (text, "mwMW"));
  bytes_more = sum (text >= 128 & text < 192);  # of a character of several bytes
  width = 9.4*(numel (text) - bytes_more - narrow - wide) + 6.2*narrow + 14*wide;
endfunction

%!assert (text_width ("mm") > text_width ("oo"));
%!assert (text_width ("φ"), text_width ("x"))
