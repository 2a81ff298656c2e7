# What the sections of rods bear along them: a panel a column, a curve a body.
set xrange [0:1]
height = 80 + 220*panels
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1000,height dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2000,2*height font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../along.".kind
  set multiplot layout panels,1 title title noenhanced margins char 12,char 3,char 5,char 3 spacing 0,40.0/height
  do for [k = 1:panels] {
    unset xlabel
    unset key
    if (k == panels) {
      set xlabel "part of the length"
      if (curves > 1 && curves <= 6) { set key at screen 0.5,screen 8.0/height center bottom horizontal noenhanced }
    }
    set ylabel labels[k] noenhanced
    eval sprintf ("plot for [j = 1:curves] $column_%d using 1:(column (j + 1)) with lines lt j lw 2 title bodies[j], 0 with lines lc rgb light lw 1 notitle", k)
  }
  unset multiplot
  unset output
}
