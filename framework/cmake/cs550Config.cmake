# The file that find_package(cs550) reads, once installed.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
include("${CMAKE_CURRENT_LIST_DIR}/cs550Targets.cmake")
