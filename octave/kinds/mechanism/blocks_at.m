## -*- texinfo -*-
## @deftypefn {} {@var{matrix} =} blocks_at (@var{index}, @var{blocks}, @var{n})
## A sparse @var{n}-by-@var{n} matrix with @var{blocks} (r-by-r-by-b) in the rows and columns that the columns of
## @var{index} (r-by-b) have; what falls together is added.
## @end deftypefn

function matrix = blocks_at (index, blocks, n)
  [r, b] = size (index);
  row = reshape (index, r, 1, b)(:,ones (1, r),:);
  column = reshape (index, 1, r, b)(ones (1, r),:,:);
  matrix = sparse (row(:), column(:), blocks(:), n, n);
endfunction

%!test
%! blocks = cat (3, [1 2; 3 4], [5 6; 7 8]);
%! assert (full (blocks_at ([1 3; 2 2], blocks, 3)), [1 2 0; 3 4+8 7; 0 6 5]);
