set logscale xy
set xlabel "step h (s)"
set ylabel "error after 1 s (rad)"
set format y "10^{%T}"
set key bottom right
plot file using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb wrong title "explicit", \
     file using 1:3 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb right title "implicit midpoint", \
     20*x with lines dashtype 2 linewidth 1.5 linecolor rgb faint title "slope 1", \
     30*x**2 with lines dashtype 3 linewidth 1.5 linecolor rgb faint title "slope 2"
