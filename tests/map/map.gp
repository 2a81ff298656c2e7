# Folders and the calls between them: drawing.gp has what is drawn, in pixels from the upper left corner.
load "settings.gp"
load look
unset border
unset tics
set margins 0, 0, 0, 0
set xrange [0:width]
set yrange [height:0]
do for [kind in "svg png"] {
  if (kind eq "svg") { set terminal svg size width,height dynamic font "sans-serif,11" background "white" noenhanced }
  if (kind eq "png") { set terminal pngcairo size 2*width,2*height font "sans-serif,8" fontscale 2 linewidth 2 \
                                             noenhanced }
  small = kind eq "svg" ? "sans-serif,11" : "sans-serif,8"
  large = kind eq "svg" ? "sans-serif,14" : "sans-serif,10.5"
  title = kind eq "svg" ? "sans-serif,20" : "sans-serif,15"
  set label "The folders of octave/ and the calls between them" at 15,40 font title
  set label "A dot: so many calls go from the folder at its left to the folder at its lane's end." at 15,70 font large
  set label "Of generated/: what is called by its name." at 15,90 font large
  load "drawing.gp"
  set output "../map.".kind
  plot NaN notitle
  unset output
  unset label
  unset arrow
  unset object
}
