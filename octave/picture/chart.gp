# The work-precision diagram: error against seconds and calls, a curve a method, and the ladder of models beside them.
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set grid
shape(k) = int (word ("7 5 9 11 13 15 6 4 8 10 12 14", (k - 1) % 12 + 1))
colours = "0x1f77b4 0xd62728 0x2ca02c 0xff7f0e 0x9467bd 0x8c564b 0xe377c2 0x7f7f7f 0xbcbd22 0x17becf ". \
          "0x000000 0x004488 0xaa3377 0x999933"
colour(k) = int (word (colours, k))
curve(k, x) = sprintf (", $curve_%d using %d:%d with linespoints pt %d ps 0.7 lc rgb %d title '%s'", k, x, x + 1, shape (k), \
    colour (k), methods[k]). \
  sprintf (", $part_%d using %d:%d with points pt 7 ps 0.35 lc rgb 'white' notitle", k, x, x + 1). \
  sprintf (", $failed_%d using %d:%d with points pt 2 ps 1.2 lw 2 lc rgb %d notitle", k, x, x + 1, colour (k))
panel_1 = "plot tolerance with lines dt 2 lc rgb '#606060' notitle, floor with lines dt 3 lc rgb '#606060' notitle"
panel_2 = "plot NaN notitle"
ring(x) = sprintf (", $own using %d:%d with points pt 6 ps 2.2 lw 2 lc rgb 'black' title 'auto'", x, x + 1)
do for [k = 1:|methods|] {
  panel_1 = panel_1.curve (k, 1)
  panel_2 = panel_2.curve (k, 3)
}
panel_1 = panel_1.ring(1)
panel_2 = panel_2.ring(3)

do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1600,760 dynamic font "sans-serif,14" background "white" enhanced }
  if (kind eq "png") { set terminal pngcairo size 3200,1520 font "sans-serif,11" fontscale 2 linewidth 2 pointscale 2 }
  set output "../chart.".kind
  set multiplot
  set label 1 title at screen 0.5,0.965 center noenhanced font ",16"
  set label 2 "largest error of a point over all frames; white inside: extrapolated from a part of the duration; crosses: failed; ". \
    "dashed: the scene's tolerance; dotted: the reference's own error" \
    at screen 0.5,0.03 center textcolor rgb "#606060" font ",12"
  set tmargin at screen 0.91
  set bmargin at screen 0.15
  set yrange [1e-11:3]
  set lmargin at screen 0.055
  set rmargin at screen 0.31
  set xlabel "seconds"
  set ylabel "error, m"
  unset key
  eval panel_1
  unset label 1
  unset label 2
  set lmargin at screen 0.36
  set rmargin at screen 0.615
  if (drifts) {
    set autoscale y
    set xlabel "seconds"
    set ylabel "constraint drift, m or rad"
  } else {
    set xlabel "calls"
    unset ylabel
  }
  set key at screen 0.625,0.9 left top reverse Left noenhanced samplen 2 spacing 1.15 font ",11"
  eval panel_2
  unset key
  set lmargin at screen 0.785
  set rmargin at screen 0.985
  set bmargin at screen 0.6
  set autoscale y
  set offsets graph 0.05, graph 0.15, graph 0.1, graph 0.05
  set xlabel "seconds, models of the ladder"
  set ylabel "error of the centreline, m" offset 1
  if (rungs > 0) {
    plot $ladder using 1:2 with points pt 7 ps 0.8 lc rgb "#1f77b4" notitle, \
         "" using 1:2:3 with labels left rotate by 40 offset 0.4,0.4 font ",10" noenhanced notitle, \
         $chosen using 1:2 with points pt 6 ps 2.4 lw 2 lc rgb "#000000" notitle
  }
  set tmargin at screen 0.46
  set bmargin at screen 0.15
  set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.1
  set key default
  set key top left reverse Left
  set format x "%g"
  set xlabel "N, size of the model"
  set ylabel "s per simulated s"
  if (sizes > 0) {
    plot $cost using 1:2 with linespoints pt 7 lw 2 lc rgb "#1f77b4" title "solver auto", \
        cost_first_high*(x/cost_first_low)**2 with lines dt 2 lc rgb "#606060" title "N²"
  }
  unset multiplot
  unset output
  reset
  set logscale xy
  set format x "10^{%L}"
  set format y "10^{%L}"
  set grid
}
