set xlabel "height of the drop (m)"
set ylabel "first rebound over e^2 H"
set yrange [0.95:1.05]
set key bottom left
plot 1 with lines dashtype 2 linewidth 1.5 linecolor rgb faint notitle, \
     file using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb right title "e = 1", \
     file using 1:3 with points pointtype 7 pointsize 0.6 linecolor rgb wrong title "e = 0.8", \
     file using 1:4 with points pointtype 7 pointsize 0.6 linecolor rgb third title "e = 0.5"
