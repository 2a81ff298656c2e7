## -*- texinfo -*-
## @deftypefn {} {@var{fields} =} sweep_settings ()
## What a sweep takes beside the options of @code{driver}, a row each: name, default, kind (see @code{take_fields}).
##
## @table @code
## @item vary, zip
## "rod.length=0.2:0.1:1; solver.tolerance=1e-4,1e-5": all combinations of the values, or the k-th of each together
## @item random, seed
## so many points of a Latin hypercube over the ranges of vary, "rod.length=0.2..1", for a seed of the generator
## @item over
## the path of a table, CSV: a header of names and a row a point
## @item table
## the same as a cell array, a row of names and a row a point (from Octave)
## @item at
## one point, "rod.length=0.2; solver.tolerance=1e-4"
## @item observe
## what to keep of each run (see @code{read_observe})
## @item engine, jobs
## what distributes the processes, and how many of them at a time
## @item hosts
## machines for GNU parallel (see @code{refuse_hosts})
## @item load, memory
## no process begins while the machine's load is above the one, or less than the other of its memory is free, "2G"; of
## Slurm, what a process is given
## @item time_limit
## seconds after which a point has failed
## @item keep
## whether the tables of each point stay, history.csv, summary.json and so on
## @item dry
## whether the commands are to be printed, and no more
## @item gather
## whether nothing is to be run, and the table made of what there is
## @item point
## the key of one point, under which its row is published (see @code{sweep_point})
## @end table
## @end deftypefn

function fields = sweep_settings ()
  fields = {
    "vary",    "",      "text"
    "zip",     "",      "text"
    "random",  [],      "positive number of points"
    "seed",    1,       "nonnegative number"
    "over",    "",      "text"
    "table",   {},      "struct array, or cell array"
    "at",      "",      "text"
    "observe", "estimated_error_m", "text"
    "engine",  "auto",  "\"auto\", \"parallel\", \"make\" or \"slurm\""
    "jobs",    [],      "positive number of processes"
    "hosts",   "",      "text"
    "load",    [],      "positive number"
    "memory",  "",      "text"
    "time_limit", [],   "positive number of seconds"
    "keep",    false,   "true or false"
    "dry",     false,   "true or false"
    "gather",  false,   "true or false"
    "point",   "",      "text"
  };
endfunction

%!test # the defaults are of their kinds
%! for field = sweep_settings ().'
%!   assert (isempty (field{2}) || isempty (value_error (field{3}, field{2})), field{1});
%! endfor
