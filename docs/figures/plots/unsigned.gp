set xlabel "height of the upper beam over touching (m)"
set ylabel "separation (m)"
set xrange [0.3:-0.3]
set xzeroaxis linecolor rgb faint
set key top center
plot file using 1:2 with lines linewidth 2.5 linecolor rgb right title "signed", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb wrong title "distance"
