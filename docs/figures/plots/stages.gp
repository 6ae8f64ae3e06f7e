set style data histograms
set style histogram rowstacked
set style fill solid 0.85 border rgb "#ffffff"
set boxwidth 0.6
set ylabel "milliseconds per step"
set bmargin 4
set key outside right top invert
set xtics font ",11"
array colour[6] = ["#0072b2", "#8a9099", "#009e73", "#cc79a7", "#e69f00", "#d55e00"]
plot for [i=2:7] file using i:xtic(1) linecolor rgb colour[i-1] title columnheader(i)
