# Many runs over more than two fields: an axis a field and one of what was observed, a line a point, coloured by that.
count = |names|
width = 260 + 200*count
height = 640
set xrange [1:count]
set yrange [0:1]
set cbrange [c_low:c_high]
unset ytics
unset grid
set border 0
set xtics scale 0 offset 0,-0.3
set xtics ()
do for [k = 1:count] {
  set xtics add (names[k] k)
  set arrow from k,0 to k,1 nohead lw 1.5 lc rgb "#404040" front
}
set xtics noenhanced
set style textbox opaque noborder fillcolor rgb "white" margins 0.4,0.2
do for [k = 1:|tic_text|] {
  x = tic_axis[k]
  y = tic_part[k]
  set arrow from x - 0.015,y to x,y nohead lw 1.5 lc rgb "#404040" front
  set label tic_text[k] at x - 0.025,y right noenhanced textcolor rgb "#202020" front boxed
}
set colorbox user origin graph 1.02, graph 0 size graph 0.02, graph 1
if (c_step > 0) { set cbtics c_step }

do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size width,height dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2*width,2*height font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../sweep.".kind
  set lmargin at screen 80.0/width
  set rmargin at screen 1 - 180.0/width
  set tmargin at screen 1 - 60.0/height
  set bmargin at screen 70.0/height
  set title title noenhanced
  plot $failed using 1:2 with lines lw 1 dt 2 lc rgb "#c00000", \
       $points using 1:2:3 with lines lw 1.2 palette
  unset output
}
