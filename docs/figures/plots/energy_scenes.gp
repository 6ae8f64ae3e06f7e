set xlabel "time (s)"
set ylabel "energy over its start"
set key bottom left
plot file using 1:2 with lines linewidth 2 linecolor rgb right title "bounce", \
     file using 1:3 with lines linewidth 2 linecolor rgb wrong title "dominoes", \
     file using 1:4 with lines linewidth 2 linecolor rgb third title "stack10", \
     file using 1:5 with lines linewidth 2 linecolor rgb fourth title "wall"
