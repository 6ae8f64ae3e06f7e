set logscale xy
set format y "10^{%T}"
set xlabel "vertices n of each hull"
set ylabel "pairs of edges"
plot file using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb faint title "all pairs", \
     file using 1:4 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb wrong title "crossing, prisms at 90°", \
     file using 1:3 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb right title "crossing, random hulls"
