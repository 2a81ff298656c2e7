# One picture a frame: the surface shaded, its mesh and the rod with what lies behind hidden. what: "frames" or "figure3".
ink_rod = "#b03000"
set view equal xyz
unset border
unset tics
unset colorbox
set pm3d depthorder border lc rgb "#d8dee4" lw 0.3
set palette defined (0 "#8fa3b3", 1 "#f3f5f6")
set hidden3d front
set xyplane 0
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set zrange [z_low:z_high]
set margins 0,0,0,0

do for [frame=first:last] {
  load sprintf("%04d.gp", frame)
  do for [kind in kinds] {
    if (kind eq "png") { set terminal pngcairo size 1280,720 font "sans-serif,12.5" }
    if (kind eq "svg") { set terminal svg size 1000,750 dynamic font "sans-serif,15" background "white" }
    if (kind eq "pdf") { set terminal pdfcairo size 17.5cm,13cm font "sans-serif,9" }
    set output name.".".kind
    set view elevation, azimuth, magnification
    set label 1 title at screen 0.04,0.95 noenhanced front font sprintf("sans-serif,%g", 0.8*title_size)
    set label 2 clock at screen 0.96,0.95 right front font "sans-serif,18"
    splot $surface using 1:2:3:4 with pm3d, \
          $surface using 1:2:3 with lines lc rgb "#9aa7b2" lw 0.4, \
          for [i=1:rods] $rod index i-1 using 1:2:3 with lines lc rgb ink_rod lw (i == rods ? 5 : 2), \
          $tip using 1:2:3 with lines lc rgb "#0072b2" lw 1.2
    unset output
  }
}
