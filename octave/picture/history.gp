# The time histories, a panel each, one above the other over the same time.
foot = spectrum ? 250 : 0
height = 105 + 190*panels + foot
set terminal svg size 1000,height dynamic font "sans-serif,15" background "white"
X(pixels) = pixels/1000.
Y(pixels) = pixels/real(height)

set output "../history.svg"
curve = dots ? "linespoints pt 7 ps 0.2" : "lines"
set multiplot
set label 1 title at screen X(95),Y(height - 25) noenhanced font sprintf("sans-serif,%g", title_size)
set xrange [t_low:t_high]
set format x ""
# as much room for the names as the longest takes
right = 930 - 9*longest_name < 815 ? 930 - 9*longest_name : 815
set key at graph 1.01,1 left top reverse Left samplen 2 noenhanced textcolor rgb ink
do for [k=1:break_count] { set arrow from breaks[k], graph 0 to breaks[k], graph 1 nohead dt 2 lw 1 lc rgb ink }

# The first curve is the widest: where curves coincide, all are seen.
do for [p=1:panels] {
  load sprintf("panel_%d.gp", p)
  bottom = 75 + 190*(panels - p) + foot
  set margins at screen X(95),at screen X(right),at screen Y(bottom),at screen Y(bottom + 150)
  set yrange [range_low:range_high]
  set ytics step
  set label 2 label at graph 0,1.1 textcolor rgb ink
  if (p == panels) { set format x "%h"; set xlabel "{/:Italic t}, s" }
  marks = p == 1 && break_count > 0
  plot for [k=1:|names|] $curves using 1:k+1 with @curve lt k lw 1 + 2.5/k \
      title names[k], NaN with lines dt 2 lw 1 lc rgb ink title (marks ? "break of loads" : "")
  unset label 1
}

# The amplitudes of the oscillations, with the predicted frequencies.
if (spectrum) {
  load "spectrum.gp"
  set margins at screen X(95),at screen X(right),at screen Y(75),at screen Y(225)
  unset arrow
  set logscale xy
  set format x "%h"
  set format y "10^{%L}"
  set xtics ()
  do for [k=1:|frequency_tics|] { set xtics add (sprintf("%.9g", frequency_tics[k]) frequency_tics[k]) }
  set ytics auto
  set xrange [frequency_low:frequency_high]
  set yrange [amplitude_low:amplitude_high]
  set xlabel "frequency, Hz (".note.")" noenhanced
  set label 2 spectrum_label noenhanced
  do for [k=1:predicted_count] {
    set arrow from predicted[k], graph 0 to predicted[k], graph 1 nohead dt 2 lw 1 lc rgb ink back
  }
  plot for [k=1:|spectrum_names|] $spectrum using 1:k+1 with lines lt k lw 1 title spectrum_names[k], \
       NaN with lines dt 2 lw 1 lc rgb ink title (predicted_count > 0 ? "predicted, at rest" : "")
}
unset multiplot
