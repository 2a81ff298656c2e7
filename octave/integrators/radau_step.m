## -*- texinfo -*-
## @deftypefn {} {@var{step} =} radau_step (@var{factors}, @var{residual}, @var{panels})
## A step of Newton's iteration of @code{radau_window}: what the @var{residual}, a cell of the parts that belong to q,
## v, lambda, mu and the springs' tensions (rows of all @var{panels}, a column a stage), changes of these, where each
## panel starts where the one before it ends.
## @end deftypefn

function step = radau_step (factors, residual, panels)
  step = of_stages (factors, residual);
  if (panels == 1)
    return;
  endif
  ends = [reshape(step{1}(:,end), [], panels); reshape(step{2}(:,end), [], panels)];
  for p = 2:panels
    ends(:,p) += factors.transfer(:,:,p)*ends(:,p-1);
  endfor
  starts = [zeros(rows (ends), 1), ends(:,1:end-1)];
  half = rows (ends)/2;
  moved = cellfun (@(r) 0*r, residual, "uniformoutput", false);
  moved{1} = factors.M*starts(1:half,:)(:)*factors.by_start;
  moved{2} = factors.M*starts(half+1:end,:)(:)*factors.by_start;
  step = cellfun (@plus, step, of_stages (factors, moved), "uniformoutput", false);
endfunction

function step = of_stages (factors, residual)
  step = {0; 0; 0; 0; 0};
  for i = 1:numel (factors.stages)
    stage = factors.stages{i};
    x = radau_solve (factors, i, cellfun (@(r) r*stage.onto, residual, "uniformoutput", false));
    step = cellfun (@(sum, x) sum + real (x*stage.from), step, x(:), "uniformoutput", false);
  endfor
endfunction

%!test # two panels of x'' = -k x without ties: the second goes on from the first
%! rule = radau_rule (5);
%! h = 0.1; k = 4;
%! [M, K, none] = deal (speye (2), k*speye (2), sparse (2, 2));
%! springs = struct ("stiffness", zeros (0, 2), "damping", zeros (0, 2));
%! factors = radau_factors (rule, h, M, K, none, sparse (0, 2), sparse (0, 2), springs, 2);
%! moved = {[1; 0]*factors.by_start, zeros(2, 5), zeros(0, 5), zeros(0, 5), zeros(0, 5)};  # from x = 1
%! step = radau_step (factors, moved, 2);
%! assert (step{1}, cos (2*h*[rule.c; 1 + rule.c]), 1e-9);
%! assert (step{2}, -2*sin (2*h*[rule.c; 1 + rule.c]), 1e-9);
