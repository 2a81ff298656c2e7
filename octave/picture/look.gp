# The look that all pictures share: colours that the colour-blind can tell apart (Okabe and Ito), fine grey axes.
set encoding utf8

set linetype 1 lc rgb "#0072b2" lw 2
set linetype 2 lc rgb "#d55e00" lw 2
set linetype 3 lc rgb "#009e73" lw 2
set linetype 4 lc rgb "#cc79a7" lw 2
set linetype 5 lc rgb "#e69f00" lw 2
set linetype 6 lc rgb "#56b4e9" lw 2
set linetype cycle 6

ink   = "#303030"
body  = "#56b4e9"
light = "#a0a0a0"
faint = "#dcdcdc"

# Viridis, from nothing to the largest value.
set palette defined (0 "#440154", 1 "#472d7b", 2 "#3b528b", 3 "#2c728e", 4 "#21918c", \
                     5 "#28ae80", 6 "#5ec962", 7 "#addc30", 8 "#fde725")

set border lc rgb "#606060" lw 1
set tics nomirror textcolor rgb ink
set grid lc rgb faint lw 1 dt 1
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
unset key
set style fill solid noborder
