# Regions of stability, the wall of adaptive explicit methods, numerical damping, resonances, energy over many periods.
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size 1600,900 dynamic font "sans-serif,14" background "white" }
  if (kind eq "png") { set terminal pngcairo size 3200,1800 font "sans-serif,11" fontscale 2 linewidth 2 \
                                             pointscale 1.5 }
  set output "../stability.".kind
  set multiplot layout 2,3 margins 0.055,0.985,0.085,0.94 spacing 0.075,0.15
  set grid
  set key top left noenhanced samplen 2

  set title "regions of stability, |R(h λ)| = 1; the rod's modes at rk4's limit"
  set xlabel "Re h λ"
  set ylabel "Im h λ"
  set xrange [-5:2]
  set yrange [0:5]
  plot $rk4_region using 1:2 with lines lw 2 title "rk4", $ode45_region using 1:2 with lines lw 2 title "ode45", \
       $ode23_region using 1:2 with lines lw 2 title "ode23", \
       $marks using 1:2 with points pt 7 ps 0.7 lc rgb "black" title "h ω, 7 + 7 modes"
  set autoscale

  set title "adaptive explicit methods: no tolerance passes the wall"
  set logscale x
  set format x "10^{%L}"
  set xlabel "tolerance, m"
  set ylabel "mean h ω_{max}"
  set yrange [0:2]
  set key bottom right
  plot $ode45_wall using 1:2 with linespoints lw 2 pt 7 title "ode45", \
       $ode23_wall using 1:2 with linespoints lw 2 pt 5 title "ode23", \
       ode45_limit lc 1 dt 2 title sprintf("limit %.3f", ode45_limit), \
       ode23_limit lc 2 dt 2 title sprintf("limit %.3f", ode23_limit)
  unset logscale
  set format x
  set autoscale

  set title "generalized-α at h ω = 10^4"
  set xlabel "ρ_∞"
  set ylabel "amplitude a step"
  set xrange [0:1.05]
  set yrange [0:1.05]
  set key top left
  plot x dt 2 title "predicted", $damping using 1:2 with points pt 7 ps 1.2 title "measured"
  set autoscale

  set title "trigonometric steps: resonances at h ω = k π"
  set xlabel "h ω"
  set ylabel "energy error"
  set logscale y
  set format y "10^{%L}"
  set key bottom right
  do for [k = 1:3] { set arrow k from first k*pi, graph 0 to first k*pi, graph 1 nohead dt 3 lc rgb "#606060" }
  plot $resonances using 1:2 with linespoints lw 2 pt 7 ps 0.6 title "largest deviation over 1000 steps"
  do for [k = 1:3] { unset arrow k }
  unset logscale
  set format y "%g"

  set title "energy, trigonometric, h ω = 2"
  set xlabel "periods of free bending"
  set ylabel "E/E_0 - 1"
  set format x "%g"
  plot $trigonometric using 1:2 with points pt 7 ps 0.15 notitle
  set key top right
  set offsets graph 0, graph 0, graph 0.25, graph 0
  set title "energy, h ω = 0.5"
  plot $stormer_verlet using 1:2 with points pt 7 ps 0.15 title "stormer_verlet", \
       $implicit_midpoint using 1:2 with points pt 7 ps 0.15 title "implicit_midpoint"
  unset multiplot
  unset output
  reset
}
