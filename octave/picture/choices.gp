# Estimated against true errors, a point a scene, with what is promised of them: the band 0.3 to 10, and the tolerance.
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
end = largest > 2 ? 2*largest : 4
set xrange [0.8e-3:end]
set yrange [0.8e-3:10*end]
set xlabel "true error / tolerance"
set ylabel "estimated error / tolerance"
set key bottom left Left reverse samplen 2 textcolor rgb ink
set samples 400

everything = "plot x < 0.05 ? NaN : 10*x with lines lc rgb light dt 2 title 'the band that is promised, 0.3 to 10'"
everything = everything.", x < 0.05 || x > 1 ? NaN : 0.3*x with lines lc rgb light dt 2 notitle"
do for [k = 1:|sorts|] {
  everything = everything.sprintf(", $sort_%d using 1:2 with points pt %d ps 1.3 lt %d title '%s'", k, 5 + 2*k, k, sorts[k])
}
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lc rgb ink dt 3
set label 2 "tolerance" at 1.06,graph 0.97 textcolor rgb "#606060"

do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1000,700 dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2000,1400 font "sans-serif,12" fontscale 2 linewidth 2 }
  set title sprintf("%d of %d scenes as promised, the largest error %.2g tolerances", good, scenes, largest) noenhanced
  set output "../choices.".kind
  eval everything
  unset output
}
