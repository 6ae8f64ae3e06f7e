set logscale x
set xlabel "size of the bodies (m)"
set ylabel "pairs with an edge contact (%)"
set yrange [0:112]
set key bottom right
plot file using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb wrong title "absolute test of parallel edges", \
     file using 1:3 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb right title "relative test"
