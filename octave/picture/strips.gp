# The time histories of a frame, up to which they are coloured; see strip_data.m.
bottom(i) = strip_bottom + (strips - i)*(strip_height + 30)
unset label
unset arrow
unset ylabel
set xrange [t_low:t_high]
column = 1
last_row = (frame - 1)/stride
name = 1
do for [i=1:strips] {
  set margins at screen R(strip_left),at screen R(25),at screen Y(bottom(i)),at screen Y(bottom(i) + strip_height)
  set yrange [low[i]:high[i]]
  set ytics step[i]
  set xlabel (i == strips ? "{/:Italic t}, ".t_unit : "")
  set xtics ()
  do for [k=ceil(t_low/t_step):floor(t_high/t_step)] {
    set xtics add (i == strips ? sprintf("%.9g", k*t_step/t_scale) : "" k*t_step)
  }
  set label 1 labels[i] at screen R(strip_left),Y(bottom(i) + strip_height + 14) noenhanced
  n = curves[i]
  do for [k=1:named[i]] {
    set label 1+k names[name] at screen R(25 + places[name]),Y(bottom(i) + strip_height + 14) right \
        noenhanced
    if (names[name] ne "…") { set label 1+k textcolor linetype k }
    name = name + 1
  }
  plot for [k=1:n] $history using 1:column+k with lines lc rgb light notitle, \
       for [k=1:n] $history using 1:column+k every ::0::last_row with lines lt k notitle, \
       for [k=1:n] $history using 1:column+k every ::last_row::last_row with points lt k pt 7 ps 1.2 notitle
  column = column + n
  unset label
}
unset format
