# The labs: number and topic. Everything else is found by these two, see lab_code.cmake.
cs550_lab(1 integration)
cs550_lab(2 half_edge_mesh)
cs550_lab(3 hill_climbing)
cs550_lab(4 separating_axis)
cs550_lab(5 clipping)
cs550_lab(6 naive_solver)
cs550_lab(7 constraint_solver)
