# Convergence in modes of rods on surfaces, a curve a scene.
set logscale y
set format y "10^{%L}"
set xlabel "polynomials for each coordinate"
set ylabel "largest distance from the run with the most, m"
set key top right noenhanced textcolor rgb ink
set xtics 2
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 900,600 dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 1800,1200 font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../surface_modes.".kind
  plot for [k=1:|names|] $modes using 1:k+1 with linespoints lt k pt 7 title names[k]
  unset output
}
