## -*- texinfo -*-
## @deftypefn {} {@var{step} =} radau_step (@var{factors}, @var{residual}, @var{panels})
## A step of Newton's iteration of @code{radau_window}: what the @var{residual}, a cell of the parts that belong to q,
## v, lambda, mu and the springs' tensions (rows of all @var{panels}, a column a stage), changes of these, where each
## panel starts where the one before it ends.
## @end deftypefn

function step = radau_step (factors, residual, panels)
  stages = columns (factors.stages{1}.from);
  residual = vertcat (cellfun (@(r) reshape (r, [], stages), residual, "uniformoutput", false){:});
  of_stage = arrayfun (@(i) radau_solve (factors, i, residual*factors.stages{i}.onto), ...
                       1:numel (factors.stages), "uniformoutput", false);
  if (panels > 1)
    of_stage = with_starts (factors, of_stage, panels);
  endif
  step = 0;
  for i = 1:numel (of_stage)
    step += real (of_stage{i}*factors.stages{i}.from);
  endfor
  step = mat2cell (step, cellfun (@numel, factors.parts), columns (step));
endfunction

## what the panels before do to each
function of_stage = with_starts (factors, of_stage, panels)
  [q, v] = factors.parts{1:2};
  ends = 0;
  for i = 1:numel (of_stage)
    ends += real (factors.stages{i}.from(end)*of_stage{i}([q, v]));
  endfor
  ends = reshape (permute (reshape (ends, [], panels, 2), [1 3 2]), [], panels);
  for p = 2:panels
    ends(:,p) += factors.transfer(:,:,p)*ends(:,p-1);
  endfor
  starts = [zeros(rows (ends), 1), ends(:,1:end-1)].';
  panel = cellfun (@(part) repelem (1:panels, numel (part)/panels), factors.parts, "uniformoutput", false);
  starts = starts([panel{:}],:);
  for i = 1:numel (of_stage)
    of_stage{i} += sum (factors.stages{i}.by_start.*starts, 2);
  endfor
endfunction

%!test # two panels of x'' = -k x without ties: the second goes on from the first
%! rule = radau_rule (5);
%! h = 0.1; k = 4;
%! [M, K, none] = deal (speye (2), k*speye (2), sparse (2, 2));
%! springs = struct ("stiffness", zeros (0, 2), "damping", zeros (0, 2));
%! factors = radau_factors (rule, h, M, K, none, sparse (0, 2), sparse (0, 2), springs, 2);
%! moved = {[1; 0]*sum(rule.inverse, 2).'/h, zeros(2, 5), zeros(0, 5), zeros(0, 5), zeros(0, 5)};  # from x = 1
%! step = radau_step (factors, moved, 2);
%! assert (step{1}, cos (2*h*[rule.c; 1 + rule.c]), 1e-9);
%! assert (step{2}, -2*sin (2*h*[rule.c; 1 + rule.c]), 1e-9);
