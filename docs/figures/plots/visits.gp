set logscale xy
set format xy "10^{%T}"
set yrange [1:3e6]
set xlabel "vertices n"
set ylabel "dot products of a query"
plot file using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb faint title "brute force", \
     file using 1:3 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb wrong title "climb from a random start", \
     file using 1:4 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb right title "climb from the answer for a direction 2° away", \
     5*sqrt(x) with lines dashtype 2 linewidth 1.5 linecolor rgb faint title "5 √n"
