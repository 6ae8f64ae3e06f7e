set xlabel "time (s)"
set ylabel "gap between the cubes (m)"
set xzeroaxis linecolor rgb faint
set yrange [-3:2.5]
set key bottom left
plot file using 1:2 with lines linewidth 2.5 linecolor rgb right title "−j n on A, +j n on B", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb wrong title "+j n on A, −j n on B"
