# Mechanisms: error and constraint drift against seconds, a curve a method, and the cost of chains beside them.
colour(k) = int (word ("0x1f77b4 0xd62728 0x2ca02c 0xff7f0e 0x9467bd 0x8c564b 0xe377c2 0x7f7f7f", k))
shape(k) = int (word ("7 5 9 11 13 15 6 4", k))
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1500,600 dynamic font "sans-serif,14" background "white" enhanced }
  if (kind eq "png") { set terminal pngcairo size 3000,1200 font "sans-serif,11" fontscale 2 linewidth 2 pointscale 2 }
  set output "../chart.".kind
  set logscale xy
  set format xy "10^{%L}"
  set grid
  set multiplot
  set label 1 title at screen 0.5,0.96 center noenhanced font ",16"
  set tmargin at screen 0.9
  set bmargin at screen 0.13
  set xlabel "seconds"
  set lmargin at screen 0.065
  set rmargin at screen 0.33
  set ylabel "error of the rods' ends, m"
  unset key
  set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
  plot for [k=1:|methods|] "$curve_".k using 1:2 with linespoints pt shape (k) ps 0.7 lc rgb colour (k) \
      title methods[k]
  set lmargin at screen 0.40
  set rmargin at screen 0.66
  set ylabel "constraint drift, m or rad"
  unset label 1
  set key at screen 0.67,0.9 left top reverse Left samplen 2 noenhanced
  plot for [k=1:|methods|] "$curve_".k using 1:3 with linespoints pt shape (k) ps 0.7 lc rgb colour (k) \
      title methods[k]
  set key default
  set key top left
  set lmargin at screen 0.83
  set rmargin at screen 0.985
  set format xy "%g"
  set xlabel "rods of the chain"
  set ylabel "s per simulated s"
  plot $cost using 1:2 with linespoints pt 7 lc rgb colour (1) title "radau"
  unset multiplot
  unset output
  reset
}
