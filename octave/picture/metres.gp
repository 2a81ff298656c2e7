# The axes of places: tics and labels in the unit of the scene's extent; see scene_settings.m.
set xtics ()
set ytics ()
do for [k=ceil(x_low/metre_step):floor(x_high/metre_step)] {
  set xtics add (sprintf("%.9g", k*metre_step/metre_scale) k*metre_step)
}
do for [k=ceil(y_low/metre_step):floor(y_high/metre_step)] {
  set ytics add (sprintf("%.9g", k*metre_step/metre_scale) k*metre_step)
}
set xlabel "{/:Italic b}^1, ".metre_unit
set ylabel "{/:Italic b}^2, ".metre_unit
