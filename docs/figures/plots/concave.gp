set xlabel "t, along the chord of the arc"
set ylabel "separation (m)"
set key bottom center
plot file index 0 using 1:2 with lines linewidth 2.5 linecolor rgb right title "s(n(t))", \
     file index 0 using 1:3 with lines linewidth 2 dashtype 2 linecolor rgb wrong title "s(n(t)) / |n(t)|", \
     file index 1 using 1:2 with points pointtype 7 pointsize 0.8 linecolor rgb right title "crossings", \
     file index 1 using 1:3 with points pointtype 7 pointsize 0.6 linecolor rgb wrong notitle
