## -*- texinfo -*-
## @deftypefn {} {} check_tags (@var{html})
## An error unless every tag of a page that is opened is closed in its turn.
## @end deftypefn

function check_tags (html)
  html = regexprep (html, "<script[^>]*>.*?</script>|<style>.*?</style>|<!DOCTYPE html>", "");
  opened = {};
  for tag = regexp (html, '<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>', "tokens")
    [slash, name, closed] = tag{1}{:};
    if (isempty (slash) && isempty (closed) && ! any (strcmp (name, {"meta", "link", "input", "br", "img"})))
      opened{end+1} = name;
    elseif (! isempty (slash))
      assert (opened{end}, name);
      opened(end) = [];
    endif
  endfor
  assert (isempty (opened));
endfunction

%!test check_tags ("<p>a<br>b<svg/></p>");
%!error check_tags ("<p><b></p></b>")
%!error check_tags ("<p>")
