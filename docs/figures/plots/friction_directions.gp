set polar
set size ratio -1
unset border
unset tics
set grid polar pi/6 linecolor "#e4e6ea"
set rrange [0:1.6]
set rtics 0.5,0.5,1.5 format "" scale 0
unset raxis
set label "0.5" at 0.5,0 offset 0,-0.8 center
set label "1" at 1.1,0 offset 0,-1.3 center
set label "1.5" at 1.55,0 offset 0,-0.8 center
set key outside right top
plot file using 1:2 with lines linewidth 2.5 linecolor rgb wrong title "each component limited", \
     file using 1:3 with lines linewidth 2.5 linecolor rgb right title "disk"
