set xlabel "time (s)"
set ylabel "height lost by the top box (mm)"
set yrange [0:80]
set key center right
plot file using 1:2 with lines linewidth 2 linecolor rgb wrong title "without warm starting", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb right title "with warm starting"
