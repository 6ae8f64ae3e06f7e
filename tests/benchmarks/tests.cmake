# cs550_bench: the program behind ./cs550 bench, and the tests of what it measures with. It needs Google
# Benchmark. Bullet and ODE (package group `peers`) are optional.
find_package(benchmark QUIET CONFIG)
if(NOT benchmark_FOUND)
  message(STATUS "Without ./cs550 bench: Google Benchmark is missing (libbenchmark-dev)")
  return()
endif()
if(NOT EXISTS "${PROJECT_SOURCE_DIR}/docs/figures")
  message(STATUS "Without ./cs550 bench: docs/figures, which draws its plots, is missing")
  return()
endif()
pkg_check_modules(bullet QUIET IMPORTED_TARGET bullet)
pkg_check_modules(ode QUIET IMPORTED_TARGET ode)

set(benchmarks "${PROJECT_SOURCE_DIR}/tests/benchmarks")
file(GLOB benchmark_sources CONFIGURE_DEPENDS "${benchmarks}/engines/*.cpp" "${benchmarks}/quality/*.cpp"
     "${benchmarks}/report/*.cpp" "${benchmarks}/runs/*.cpp" "${benchmarks}/scenes/*.cpp" "${benchmarks}/stages/*.cpp"
     "${benchmarks}/verb/selection.cpp" "${PROJECT_SOURCE_DIR}/framework/cli/command_line.cpp"
     "${PROJECT_SOURCE_DIR}/framework/cli/system/*.cpp")
foreach(peer bullet ode)
  if(NOT ${peer}_FOUND)
    message(STATUS "Without a comparison with ${peer}: package lib${peer}-dev is missing")
    list(REMOVE_ITEM benchmark_sources "${benchmarks}/engines/${peer}_engine.cpp")
  endif()
endforeach()

set(counted_allocations "${PROJECT_SOURCE_DIR}/tests/engine/counted_allocations.cpp")
add_library(cs550_benchmarks STATIC ${benchmark_sources} "${counted_allocations}")
target_link_libraries(cs550_benchmarks PRIVATE cs550_warnings
  PUBLIC cs550_test_support cs550_files benchmark::benchmark CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json)
cs550_unity(cs550_benchmarks 8)
set_source_files_properties("${counted_allocations}" "${benchmarks}/engines/bullet_engine.cpp"
  "${benchmarks}/engines/ode_engine.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
foreach(peer bullet ode)
  string(TOUPPER ${peer} name)
  target_compile_definitions(cs550_benchmarks PRIVATE CS550_HAS_${name}=$<BOOL:${${peer}_FOUND}>)
  if(${peer}_FOUND)
    target_link_libraries(cs550_benchmarks PRIVATE PkgConfig::${peer})
  endif()
endforeach()

add_executable(cs550_bench "${benchmarks}/verb/main.cpp" "${PROJECT_SOURCE_DIR}/docs/figures/benchmark_figures.cpp")
target_include_directories(cs550_bench PRIVATE "${PROJECT_SOURCE_DIR}/docs/figures")
target_link_libraries(cs550_bench PRIVATE cs550_benchmarks cs550_warnings)
cs550_link_labs(cs550_bench fast reference stub)

cs550_add_own_tests(benchmarks cs550_benchmarks)
add_test(NAME benchmarks.verb
         COMMAND sh "${benchmarks}/verb_test.sh" "$<TARGET_FILE:cs550_bench>" "${PROJECT_SOURCE_DIR}"
                 "${PROJECT_BINARY_DIR}/bench_verb")
set_tests_properties(benchmarks.verb PROPERTIES LABELS benchmarks TIMEOUT 300)
