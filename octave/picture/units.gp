# Frames are laid out in units, from the left, the right, the bottom and the top; see frame_layout.m.
set terminal pngcairo size width,height font "sans-serif,12.5" fontscale unit linewidth unit pointscale unit
X(units) = units*real(unit)/width
R(units) = 1 - X(units)
Y(units) = units*real(unit)/height
T(units) = 1 - Y(units)
units_high = height/real(unit)

# A title that is too long for a high frame is set smaller still.
fitting(size, room) = width < height && size*strlen(title) > room ? room/real(strlen(title)) : size
