# One picture a frame, or of all at once for the figure: the surface shaded, its mesh and the rod, with what lies
# behind them hidden, but for a thin dashed line of the rod.
ink_rod = "#b03000"
set view equal xyz
unset colorbox
frame_with_strips = kinds eq "png"
set pm3d depthorder border lc rgb "#d8dee4" lw 0.3
set palette defined (0 "#8fa3b3", 1 "#f3f5f6")
load here."units.gp"
least(a, b) = a < b ? a : b

do for [frame=first:last] {
  load sprintf("%d.gp", frame)
  do for [kind in kinds] {
    if (kind eq "png" && !frame_with_strips) { set terminal pngcairo size 2000,1500 font "sans-serif,12" \
        fontscale 2 linewidth 2 }
    if (kind eq "svg") { set terminal svg size 1000,750 dynamic font "sans-serif,15" background "white" }
    if (kind eq "pdf") { set terminal pdfcairo size 17.5cm,13cm font "sans-serif,9" }
    beside = frame_with_strips && width >= height ? R(345) : 1
    below = frame_with_strips && width < height ? Y(scene_bottom - 65) : 0
    shape = frame_with_strips ? 1.0*width/height : 4.0/3  # width by height
    set output name.".".kind
    set multiplot
    unset border
    unset tics
    unset xlabel
    set margins at screen 0,at screen beside,at screen below,at screen 0.9
    # of the same scale, wide enough for what the camera sees
    across = shape*beside
    upright = 0.9 - below
    side = least(across, upright)/0.95/least(across/2/half_width, upright/2/half_height)
    wider = -least(0, -least(side - x_high + x_low, side - y_high + y_low))/2
    set xrange [x_low-wider:x_high+wider]
    set yrange [y_low-wider:y_high+wider]
    set zrange [z_low:z_high]
    set xyplane 0
    set view elevation, azimuth
    set label 1 title at screen 0.04,0.95 noenhanced front font \
        sprintf("sans-serif,%g", 0.8*fitting(title_size, frame_with_strips ? 780 : 1300))
    set label 2 clock at screen beside - 0.02,0.95 right front font "sans-serif,18"
    set label 3 slow at screen beside - 0.02,0.9 right front
    set hidden3d front
    splot $surface using 1:2:3:4 with pm3d, \
          $surface using 1:2:3 with lines lc rgb "#9aa7b2" lw 0.4, \
          for [i=1:rods] $rod index i-1 using 1:2:3 with lines lc rgb ink_rod lw (i == rods ? 5 : 2), \
          $tip using 1:2:3 with lines lc rgb "#0072b2" lw 1.2, \
          $held using 1:2:3 with points pt 7 ps 1.4 lc rgb ink, \
          $held using 1:2:3 with points pt 7 ps 0.8 lc rgb "white"
    unset label
    unset hidden3d
    splot for [i=1:rods] $rod index i-1 using 1:2:3 with lines lc rgb ink_rod lw (i == rods ? 1.5 : 0.7) dt 2, \
          $springs using 1:2:3 with lines lc rgb ink lw 1.2, \
          $forces using 1:2:3:4:5:6 with vectors filled lc rgb "#009e73" lw 2.5
    if (frame_with_strips) {
      set border 31 lc rgb "#606060" lw 1
      set tics nomirror textcolor rgb ink
      set xtics nomirror
      set ytics nomirror
      load here."strips.gp"
    }
    unset multiplot
    unset output
  }
}
