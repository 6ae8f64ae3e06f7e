# One look for all plots: the colours of framework/drawing/palette.cpp, its font, no frame on the right.
set terminal svg size 660,340 enhanced font "Helvetica,Arial,sans-serif,13" background "#ffffff" dynamic
set output output
set border 3 linecolor "#40444c"
set tics nomirror textcolor "#1b1e23"
set grid linecolor "#e4e6ea" linewidth 1
set key top left Left reverse samplen 2.2 spacing 1.15
right = "#0072b2"
wrong = "#d55e00"
third = "#009e73"
fourth = "#cc79a7"
faint = "#5f656e"
file = data . "/" . name . ".dat"
