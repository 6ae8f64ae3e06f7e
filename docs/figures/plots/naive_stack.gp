set xlabel "time (s)"
set ylabel "height lost by the top box (m)"
set key top left
plot file using 1:2 with lines linewidth 2 linecolor rgb wrong title "naive, 1 pass", \
     file using 1:3 with lines linewidth 2 dashtype 2 linecolor rgb wrong title "naive, 4 passes", \
     file using 1:4 with lines linewidth 2 dashtype 3 linecolor rgb wrong title "naive, 20 passes", \
     file using 1:5 with lines linewidth 2.5 linecolor rgb right title "constraint solver"
