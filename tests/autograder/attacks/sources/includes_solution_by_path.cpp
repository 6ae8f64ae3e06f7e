#include "@ROOT@/solutions/lab3_hill_climbing/hill_climbing.cpp"
