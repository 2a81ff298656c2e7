# What a sweep has observed, a panel each: curves over one field, maps over two, a cross where a point failed.
width = 1000
panel_height = fields == 1 ? (down == 1 ? 560 : 300) : (across == 1 ? 640 : 420)
height = 100 + panel_height*down
right = fields == 1 ? 0.96 : 0.88
known(z) = z > 1e299 ? NaN : z
set y2range [0:1]
set xlabel names[1] noenhanced
if (logs[1]) { set logscale x; set format x "10^{%L}" }
if (fields == 2) {
  if (!logs[1]) { set xtics step }
  set ylabel names[2] noenhanced
  if (logs[2]) { set logscale y; set format y "10^{%L}" }
  unset grid
  set view map
  set pm3d corners2color mean interpolate finer[1],finer[2]
  set autoscale xfix
  set autoscale yfix
  set linetype cycle 30
  do for [k = 11:30] { set linetype k lc rgb "white" lw 0.8 }
  set cntrparam levels auto 8 firstlinetype 11
}

do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size width,height dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2*width,2*height font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../sweep.".kind
  set multiplot layout down,across title title noenhanced \
    margins 0.11,right,70.0/height,1 - 80.0/height spacing 0.24,105.0/height
  do for [k = 1:|texts|] {
    set title texts[k] noenhanced offset 0,-0.5
    panel = sprintf("$panel_%d", k)
    if (fields == 1) {
      plot panel using 1:(known($2)) with linespoints lt 1 pt 7 ps 0.6, \
           $failed using 1:(0.02) axes x1y2 with points pt 2 ps 1.6 lw 3 lc rgb "#c00000"
    }
    if (fields == 2 && grid) {
      set contour base
      splot panel using 1:2:(known($3)) with pm3d nocontour, \
            panel using 1:2:(known($3)) with lines nosurface, \
            panel using 1:2:(known($3)) with points pt 7 ps 0.25 lc rgb "white" nocontour, \
            $failed using 1:2:(0) with points pt 2 ps 1.6 lw 3 lc rgb "#c00000" nocontour
    }
    if (fields == 2 && !grid) {
      set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04
      plot panel using 1:2:(known($3)) with points pt 7 ps 1.2 palette, \
           $failed using 1:2 with points pt 2 ps 1.6 lw 3 lc rgb "#c00000"
    }
  }
  unset multiplot
  unset output
}
