# Frequency response: amplitudes of outputs a unit of an input.
set xlabel "frequency, Hz"
set ylabel "amplitude of the output a unit of the input"
set logscale xy
set xrange [f_low == f_high ? f_low/2 : f_low:f_low == f_high ? 2*f_low : f_high]
if (f_low == f_high) { set style data points } else { set style data lines }
set format y "10^{%T}"
set key outside bottom center horizontal maxcols 2 noenhanced
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1000,700 dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2000,1400 font "sans-serif,12" fontscale 2 linewidth 2 }
  set output "../response.".kind
  set title title noenhanced
  plot for [k = 1:curves] "$curve_".k lt k lw 2 pt 7 title names[k]
  unset output
}
