set xlabel "place of the blow over the length of the rod"
set ylabel "effective mass over mass"
set yrange [0:1.1]
set key bottom center
plot file using 1:2 with lines linewidth 2.5 linecolor rgb right title "closed form", \
     file every 2 using 1:3 with points pointtype 7 pointsize 0.7 linecolor rgb wrong title "effective\\_mass()"
