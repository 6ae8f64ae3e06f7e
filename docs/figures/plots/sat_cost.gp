file = data . "/crossings.dat"
set logscale xy
set format y "10^{%T}"
set xlabel "vertices n of each hull"
set ylabel "operations of one query"
plot file using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb wrong title "edge query: tests of arcs", \
     file using 1:5 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb right title "face queries: dot products"
