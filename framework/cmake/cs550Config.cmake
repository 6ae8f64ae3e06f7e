# Installed: what find_package(cs550) reads.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
include("${CMAKE_CURRENT_LIST_DIR}/cs550Targets.cmake")
