set xlabel "pass"
set ylabel "impulse (N s)"
set yrange [-0.02:1.3]
set xrange [0:10]
set key top right
plot file using 1:3 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb right title "inner support, sum clamped", \
     file using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 2 dashtype 2 linecolor rgb right title "outer support, sum clamped", \
     file using 1:5 with linespoints pointtype 7 pointsize 0.6 linewidth 2 linecolor rgb wrong title "inner support, increment clamped", \
     file using 1:4 with linespoints pointtype 7 pointsize 0.6 linewidth 2 dashtype 2 linecolor rgb wrong title "outer support, increment clamped", \
     4/7.0 with lines dashtype 3 linewidth 1.5 linecolor rgb faint title "exact: 4/7 and 0"
