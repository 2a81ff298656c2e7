## -*- texinfo -*-
## @deftypefn {} {@var{text} =} how_many (@var{number}, @var{one}, @var{many})
## A @var{number} of things, which are called @var{one} or, by default with an s, @var{many}.
## @end deftypefn

function text = how_many (number, one, many = [one "s"])
  if (number == 1)
    many = one;
  endif
  text = sprintf ("%d %s", number, many);
endfunction

%!assert ({how_many(1, "rod"), how_many(0, "rod"), how_many(2, "body", "bodies")}, {"1 rod", "0 rods", "2 bodies"})
