set xlabel "time (s)"
set ylabel "height (m)"
set yrange [-0.2:8]
set key top right
plot file using 1:2 with lines linewidth 2.5 linecolor rgb right title "smaller of push and bounce", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb wrong title "their sum", \
     3.2 with lines dashtype 3 linewidth 1.5 linecolor rgb faint title "e^2·5 m and e^4·5 m", 2.048 with lines dashtype 3 linewidth 1.5 linecolor rgb faint notitle
