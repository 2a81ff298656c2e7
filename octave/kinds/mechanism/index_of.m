## -*- texinfo -*-
## @deftypefn {} {@var{index} =} index_of (@var{mechanism}, @var{body})
## Where the coordinates (V; phi; x; y) of a @var{body} (its number) stand among those of the @var{mechanism}.
## @end deftypefn

function index = index_of (mechanism, body)
  place = mechanism.place(body,:);
  index = mechanism.groups(place(1)).index(:,place(2));
endfunction

%!assert (index_of (sample_mechanism ([0 1]).mechanism, 2), (5:8).')
