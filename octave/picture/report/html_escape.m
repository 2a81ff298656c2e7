## -*- texinfo -*-
## @deftypefn {} {@var{html} =} html_escape (@var{text})
## @var{text} as it stands between tags or in quotation marks of HTML.
## @end deftypefn

function html = html_escape (text)
  html = text;
  if (isempty (regexp (text, '[&<>"'']', "once")))  # as most texts are
    return;
  endif
  for pair = {"&", "<", ">", "\"", "'"; "&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}
    html = strrep (html, pair{:});
  endfor
endfunction

%!assert (html_escape ("<a b='c & d'>\"ž\""), "&lt;a b=&#39;c &amp; d&#39;&gt;&quot;ž&quot;")
