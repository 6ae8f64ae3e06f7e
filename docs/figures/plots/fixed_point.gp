set logscale xy
set xlabel "bound of the contraction factor, κ"
set ylabel "largest energy over its start"
set yrange [0.8:2000]
set arrow from 1,0.8 to 1,12 nohead dashtype 2 linecolor rgb faint
plot file using 1:2 with linespoints pointtype 7 pointsize 0.4 linewidth 2 linecolor rgb wrong title "board 1 : 10 : 50", \
     file using 1:3 with linespoints pointtype 7 pointsize 0.4 linewidth 2 linecolor rgb fourth title "needle 1 : 1.5 : 50", \
     file using 1:4 with linespoints pointtype 7 pointsize 0.4 linewidth 2 linecolor rgb third title "box 1 : 2.5 : 5", \
     1.0001 with lines linewidth 2 linecolor rgb right title "what the guard lets pass"
