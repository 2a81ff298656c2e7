# One picture a frame, from first to last: the scene at the left, its time histories at the right.
# Lengths are in units, from the left, the right, the bottom and the top.
set terminal pngcairo size width,height font "sans-serif,12.5" fontscale unit linewidth unit pointscale unit
X(units) = units*real(unit)/width
R(units) = 1 - X(units)
Y(units) = units*real(unit)/height
T(units) = 1 - Y(units)
units_high = height/real(unit)

strip_height = strips < 2 ? 240 : (units_high - 210 - 30*(strips - 1))/strips
bottom(i) = 65 + (strips - i)*(strip_height + 30)

set cbrange [stress_low:stress_high]
set cblabel stress_label textcolor rgb ink offset 0.3
set colorbox user origin screen R(485),Y(65) size screen X(16),Y(units_high - 240)
if (!coloured) { unset colorbox }

do for [frame=first:last] {
  load sprintf("%04d.gp", frame)
  set output sprintf("../frames/frame_%04d.png", frame)
  set multiplot

  set margins at screen X(95),at screen R(515),at screen Y(65),at screen T(65)
  set xrange [x_low:x_high]
  set xtics metre_step
  set ytics metre_step
  set yrange [y_low:y_high]
  set xlabel "{/:Italic b}^1, m" offset 0
  set ylabel "{/:Italic b}^2, m" offset 0
  set label 1 title at screen X(95),T(32) noenhanced font sprintf("sans-serif,%g", 0.75*title_size)
  set label 2 clock at screen R(25),T(70) right font "sans-serif,20"
  set label 3 zoom at screen R(25),T(104) right
  set label 4 moment_label at moment_place_low,moment_place_high center front
  if (gravity) {
    set label 5 "{/:Italic g}" at screen R(468),T(98)
    set arrow 1 from screen R(480),T(70) to screen R(480),T(130) lw 2 lc rgb ink
  }
  plot $ground with lines lc rgb ink lw 1.5, \
       $tip_path with lines lc rgb light lw 1.5, \
       for [i=1:bodies] $rest index i-1 with lines lc rgb light lw 1.5 dt 2, \
       for [i=1:bodies] $outline index i-1 with filledcurves closed fc rgb body, \
       for [i=1:coloured] $pieces index i-1 with vectors nohead lc palette lw word(thickness, i), \
       for [i=1:bodies] $outline index i-1 with lines lc rgb ink lw 0.7, \
       $pins with filledcurves closed fc rgb "white", \
       $pins with lines lc rgb ink lw 1.5, \
       $moment with lines lt 2 lw 2.5

  unset label
  unset arrow
  unset ylabel
  set xrange [t_low:t_high]
  set xtics t_step
  column = 1
  do for [i=1:strips] {
    set margins at screen R(320),at screen R(25),at screen Y(bottom(i)),at screen Y(bottom(i) + strip_height)
    set yrange [real(word(low, i)):real(word(high, i))]
    set ytics real(word(step, i))
    set xlabel (i == strips ? "{/:Italic t}, s" : "")
    set format x (i == strips ? "%h" : "")
    set label 1 word(labels, i) at screen R(320),Y(bottom(i) + strip_height + 14) noenhanced
    n = int(word(curves, i))
    set key at screen R(25),Y(bottom(i) + strip_height + 4) right bottom horizontal noenhanced samplen 1 textcolor rgb ink
    plot for [k=1:n] $history using 1:column+k with lines lc rgb light notitle, \
         for [k=1:n] $history using 1:column+k every ::0::frame-1 with lines lt k title (n > 1 && k <= int(word(named, i)) ? word(names, column + k - 1) : ""), \
         for [k=1:n] $history using 1:column+k every ::frame-1::frame-1 with points lt k pt 7 ps 1.2 notitle
    column = column + n
  }
  unset format
  unset key
  unset multiplot
  unset output
}
