set logscale y
set format y "10^{%T}"
set xlabel "passes"
set ylabel "largest |Jv| (m/s)"
set key top right
plot file using 1:2 every 4 with lines linewidth 2 linecolor rgb wrong title "10 boxes, one direction", \
     file using 1:3 every 4 with lines linewidth 2.5 linecolor rgb right title "10 boxes, back and forth", \
     file using 1:4 every 4 with lines linewidth 2 dashtype 2 linecolor rgb wrong title "5 boxes, one direction", \
     file using 1:5 every 4 with lines linewidth 2 dashtype 2 linecolor rgb right title "5 boxes, back and forth"
