# Shapes of rods, a panel each, all in one scale: what they are measured from is faint.
unset border
unset tics
unset grid
width = 1200
height = 90 + down*(50 + 1150.0/across*(y_high - y_low)/(x_high - x_low))
height = height < 330 ? 330 : (height > 1600 ? 1600 : height)
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size width,height dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2*width,2*height font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../".name.".".kind
  set multiplot layout down,across title title noenhanced margins 0.02,0.98,0.04,1 - 70.0/height spacing 0.02,50.0/height
  do for [k = 1:down*across] {
    if (k <= |titles|) {
      set title titles[k] noenhanced offset 0,-0.5
      lines = sprintf("$faint_%d with lines lc rgb light lw 1, $strong_%d with lines lt 1 lw 2.5", k, k)
      set size ratio -1
      eval "plot [x_low:x_high] [y_low:y_high] ".lines
    }
  }
  unset multiplot
  unset output
}
