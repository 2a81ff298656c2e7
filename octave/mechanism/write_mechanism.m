## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} write_mechanism (@var{folder}, @var{scene}, @var{mechanism}, @var{history}, @var{summary}, @var{start})
## All files of a mechanism's run, whole or not at all, as @code{write_run} of one rod.
## @end deftypefn

function summary = write_mechanism (folder, scene, mechanism, history, summary, start)
  publish_run (folder, {"history.csv", "summary.json"}, @write);

  function write (aside)
    write_mechanism_history (scene, mechanism, history, fullfile (aside, "history.csv"));
    summary.seconds.total = toc (start);
    write_summary (summary, fullfile (aside, "summary.json"));
  endfunction
endfunction
