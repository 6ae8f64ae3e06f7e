set xlabel "angle of the slope (°)"
set ylabel "speed after 1 s (m/s)"
plot file using 1:2 with lines linewidth 2.5 linecolor rgb right title "closed form, μ = 0.5", \
     file using 1:3 with points pointtype 7 pointsize 0.7 linecolor rgb wrong title "engine"
