set xlabel "time (s)"
set ylabel "bottom of the box above the floor (mm)"
set xzeroaxis linecolor rgb faint
set key bottom right
plot file using 1:2 with lines linewidth 2.5 linecolor rgb wrong title "Baumgarte", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb right title "soft contacts"
