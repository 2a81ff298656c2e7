# The bodies at even times in one picture, time by shade: the same plot for three terminals.
X(pixels) = pixels/1000.
Y(pixels) = pixels/850.

# Light first: what comes later is drawn over it and must not hide in it.
set palette negative
set cbrange [t_low:t_high]
set colorbox user origin screen X(910),Y(75) size screen X(16),Y(560)

set margins at screen X(95),at screen X(885),at screen Y(75),at screen Y(765)
set xrange [x_low:x_high]
set yrange [y_low:y_high]
load here."metres.gp"
set cbtics ()
do for [k=ceil(t_low/t_step):floor(t_high/t_step)] { set cbtics add (sprintf("%.9g", k*t_step/t_scale) k*t_step) }
set label 4 "{/:Italic t}, ".t_unit at screen X(910),Y(655)
set label 2 sprintf("%s, %s", duration, zoom) at screen X(95),Y(788)
if (gravity) {
  set label 3 "{/:Italic g}" at screen X(930),Y(730)
  set arrow 1 from screen X(918),Y(760) to screen X(918),Y(700) lw 2 lc rgb ink
}

do for [kind in "svg png pdf"] {
  if (kind eq "svg") { set terminal svg size 1000,850 dynamic font "sans-serif,16" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2000,1700 font "sans-serif,12" fontscale 2 linewidth 2 }
  if (kind eq "pdf") { set terminal pdfcairo size 17.5cm,14.875cm font "sans-serif,9" linewidth 0.8 }
  title_points = title_size * (kind eq "svg" ? 1 : kind eq "png" ? 0.75 : 0.56)
  set label 1 title at screen X(95),Y(820) noenhanced font sprintf("sans-serif,%g", title_points)
  set output "../figure3.".kind
  plot $ground with lines lc rgb ink lw 1.5, \
       $tip_path with lines lc rgb light lw 1, \
       for [i=1:outlines] $rests index i-1 with lines lc rgb light lw 1 dt 2, \
       for [i=1:outlines] $outlines index i-1 with filledcurves closed fc palette cb times[i] \
                          lw 0.5 fs solid border lc rgb ink, \
       $springs with lines lc rgb ink lw 1.5, \
       $pins with filledcurves closed fc rgb "white", \
       $pins with lines lc rgb ink lw 1.5
  unset output
}
