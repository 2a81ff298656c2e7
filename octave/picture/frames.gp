# One picture a frame, from first to last: the scene, its time histories at the right or below.
load here."units.gp"

set cbrange [stress_low:stress_high]
bar = scene_right - 30
set colorbox user origin screen R(bar),Y(scene_bottom) size screen X(16),Y(units_high - scene_bottom - scene_top - 145)
if (!coloured) { unset colorbox }

do for [frame=first:last] {
  load sprintf("%d.gp", frame)
  set output "../".sprintf(frame_name, frame)
  set multiplot

  set margins at screen X(95),at screen R(scene_right),at screen Y(scene_bottom),at screen T(scene_top)
  set xrange [x_low:x_high]
  set yrange [y_low:y_high]
  load here."metres.gp"
  set label 1 title at screen X(95),T(32) noenhanced font sprintf("sans-serif,%g", 0.75*fitting(title_size, 950))
  set label 2 clock at screen R(25),T(70) right font "sans-serif,20"
  set label 3 zoom at screen R(25),T(104) right
  if (coloured) { set label 6 "largest\nbending\nstress, ".stress_unit at screen R(bar),T(scene_top + 85) }
  set label 4 moment_label at moment_place_low,moment_place_high center front
  set label 7 force_label at force_place_low,force_place_high center front
  if (gravity) {
    set label 5 "{/:Italic g}" at screen R(bar - 17),T(scene_top + 33)
    set arrow 1 from screen R(bar - 5),T(scene_top + 5) to screen R(bar - 5),T(scene_top + 65) lw 2 lc rgb ink
  }
  plot $ground with lines lc rgb ink lw 1.5, \
       $tip_path every ::0::tip with lines lc rgb light lw 1.5, \
       for [i=1:bodies] $rest index i-1 with lines lc rgb light lw 1.5 dt 2, \
       for [i=1:bodies] $outline index i-1 with filledcurves closed fc rgb body, \
       for [i=1:coloured] $pieces index i-1 with vectors nohead lc palette lw thickness[i], \
       for [i=1:bodies] $outline index i-1 with lines lc rgb ink lw 0.7, \
       $springs with lines lc rgb ink lw 1.5, \
       $pins with filledcurves closed fc rgb "white", \
       $pins with lines lc rgb ink lw 1.5, \
       $moments with lines lt 2 lw 2.5, \
       $forces with lines lt 2 lw 2.5

  load here."strips.gp"
  unset multiplot
  unset output
}
