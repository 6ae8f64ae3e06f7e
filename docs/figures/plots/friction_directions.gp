set polar
set size ratio -1
unset border
unset tics
set grid polar pi/6 linecolor "#e4e6ea"
set rrange [0:1.6]
set rtics 0.5,0.5,1.5
unset raxis
set key outside right top
plot file using 1:2 with lines linewidth 2.5 linecolor rgb wrong title "each component limited", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb right title "disk"
