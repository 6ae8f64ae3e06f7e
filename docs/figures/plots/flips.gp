set xlabel "time (s)"
set ylabel "y component of ω, body frame (rad/s)"
set yrange [-6:6]
$zeros << END
0.8526 0
3.4814 0
6.1102 0
8.7389 0
11.3677 0
END
plot file using 1:2 with lines linewidth 2.5 linecolor rgb right notitle, \
     $zeros using 1:2 with points pointtype 7 pointsize 1 linecolor rgb wrong title "exact zeros"
