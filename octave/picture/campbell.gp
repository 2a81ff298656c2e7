# Campbell's diagram: frequencies against the angular velocity, with lines of so many excitations a turn.
set xlabel "angular velocity, rad/s"
set ylabel "frequency, Hz"
set xrange [0:fastest > 0 ? fastest : 1]
set yrange [0:highest]
# Of lines that are nearer to each other than letters are high, some have their names.
a_turn = fastest/(2*pi)
apart = a_turn > 0 ? ceil (0.03*highest/a_turn) : 6
do for [k = 1:6:apart] {
  set label 10 + k sprintf ("%dP", k) at graph 1.01, first k*a_turn textcolor rgb light font ",11"
  if (k*a_turn > highest) { unset label 10 + k }
}
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1000,700 dynamic font "sans-serif,15" background "white" }
  if (kind eq "png") { set terminal pngcairo size 2000,1400 font "sans-serif,12" fontscale 2 linewidth 2 }
  set label 1 title at screen 0.5,0.965 center noenhanced
  set tmargin at screen 0.92
  set rmargin at screen 0.95
  set output "../campbell.".kind
  plot for [k = 1:6] k*x/(2*pi) with lines lc rgb light lw 1 dt 3, \
       for [k = 1:branches] "$branch_".k using 1:2 with linespoints lt (k - 1) % 6 + 1 pt 7 ps speeds > 1 ? 0.5 : 1.5, \
       $unstable using 1:2 with points pt 2 ps 1.6 lw 3 lc rgb "#c00000"
  unset output
}
