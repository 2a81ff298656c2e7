# What a step of explicit methods does to the highest mode of a scene: predicted lines, measured points.
colour(k) = int (word ("0x1f77b4 0xd62728 0x2ca02c 0xff7f0e 0x9467bd 0x8c564b", k))
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1000,640 dynamic font "sans-serif,14" background "white" enhanced }
  if (kind eq "png") { set terminal pngcairo size 2000,1280 font "sans-serif,12" fontscale 2 linewidth 2 pointscale 2 }
  set output "../stability.".kind
  set label 1 title at screen 0.5,0.965 center noenhanced font ",16"
  set label 2 sprintf ("highest mode about the start, %.4g rad/s; lines predicted, points measured; vertical: limits", \
    omega) at screen 0.5,0.03 center textcolor rgb "#606060" font ",12"
  set tmargin at screen 0.91
  set bmargin at screen 0.15
  set rmargin at screen 0.97
  set grid
  set key top left reverse Left noenhanced samplen 2
  set xlabel "step times frequency, h ω"
  set ylabel "amplitude after a step"
  set xrange [0:*]
  set yrange [0.5:2]
  do for [k = 1:|methods|] {
    set arrow k from first limits[k], graph 0 to first limits[k], graph 1 nohead dt 3 lc rgb colour (k)
  }
  plot for [k = 1:|methods|] "$predicted_".k using 1:2 with lines lw 2 lc rgb colour (k) title methods[k], \
       for [k = 1:|methods|] "$measured_".k using 1:2 with points pt 7 ps 0.9 lc rgb colour (k) notitle
  unset output
}
