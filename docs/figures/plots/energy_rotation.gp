set xlabel "time (s)"
set ylabel "energy over its start"
set yrange [0.8:3.8]
set key at graph 0.97,0.5 right
plot 3.58767 with lines dashtype 2 linewidth 1.5 linecolor rgb faint title "greatest possible: 3.5877", \
     file using 1:2 with lines linewidth 2.5 linecolor rgb wrong title "explicit", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb right title "implicit midpoint"
