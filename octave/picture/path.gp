# A load path: factor against the place that moves most, and shapes along it, from faint to dark; modes are dashed.
width = 1200
height = 560
unset colorbox
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size width,height dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2*width,2*height font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../path.".kind
  set multiplot layout 1,2 title title noenhanced margins 0.07,0.98,0.12,0.9 spacing 0.07,0
  set xlabel place noenhanced
  set ylabel "factor of the loads"
  do for [k = 1:|names|] {
    if (modes > 0) { set label 20 + k sprintf("%d: %s", k, names[k]) at screen 0.54,0.93 - 0.05*k textcolor lt 2 }
  }
  plot $unstable with lines lt 1 dt 2, $stable with lines lt 1 lw 3, $events with points pt 7 ps 1 lc rgb "#d55e00", \
       $events using 1:2:(sprintf ("%d", $0 + 1)) with labels offset 1,0.7 textcolor lt 2
  unset border; unset tics; unset grid; unset xlabel; unset ylabel
  set size ratio -1
  if (modes > 0) {
    plot [x_low:x_high] [y_low:y_high] for [k = 1:shapes] "$shape_".k with lines lw 2 lc palette frac 1 - 0.85*k/shapes, \
         for [k = 1:modes] "$mode_".k with lines lt 2 lw 1.5 dt 2
  } else {
    plot [x_low:x_high] [y_low:y_high] for [k = 1:shapes] "$shape_".k with lines lw 2 lc palette frac 1 - 0.85*k/shapes
  }
  unset multiplot
  set border; set tics; set grid
  set size noratio
  unset label
  unset output
}
