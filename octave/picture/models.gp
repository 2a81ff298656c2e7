# The ladder of models: error against seconds, a point a rung, the chosen one ringed.
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set xlabel "seconds of integration"
set ylabel "largest error of the centreline in all frames, m"
set key at screen 0.5,0.045 center horizontal samplen 2 textcolor rgb ink
set offsets graph 0.05, graph 0.12, graph 0.05, graph 0.05

marks(name, n, type, colour, text) = n == 0 ? "" : \
  sprintf(", $%s using 1:2 with points pt %d ps 1.2 lt %d title '%s'", name, type, colour, text). \
  sprintf(", $%s using 1:2:3 with labels left rotate by 40 offset 0.5,0.5 font ',11' tc lt %d noenhanced notitle", \
      name, colour)
ring = chosen == 0 ? "" : ", $chosen using 1:2 with points pt 6 ps 3 lw 2 lc rgb ink title 'chosen'"
everything = "plot tolerance with lines lc rgb light dt 2 title 'tolerance'"
do for [k = 1:|curves|] {
  everything = everything.marks(sprintf("curve_%d", k), counts[k], 8 - k, k, curves[k])
}
everything = everything.marks("ode45", ode45, 5, 4, "ode45")
everything = everything.marks("extrapolated", extrapolated, 4, 4, "ode45, extrapolated").ring

do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1000,700 dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2000,1400 font "sans-serif,12" fontscale 2 linewidth 2 }
  set label 1 title at screen 0.5,0.965 center noenhanced font \
      sprintf("sans-serif,%g", title_size*(kind eq "svg" ? 1 : 0.8))
  set label 2 "labels: ".labels at graph 0.02,0.04 noenhanced \
    font sprintf("sans-serif,%d", kind eq "svg" ? 13 : 10) textcolor rgb "#606060"
  set tmargin at screen 0.92
  set bmargin at screen 0.17
  set output "../models.".kind
  eval everything
  unset output
}
