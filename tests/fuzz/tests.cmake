# Fuzz targets (libFuzzer), built by the preset `fuzz` only: they need clang, and the whole engine compiled for
# coverage. Each runs for 15 seconds under ctest, label fuzz. By hand, for longer:
#   build/fuzz/bin/fuzz_scene -max_total_time=3600 FOLDER tests/fuzz/corpus/scene
# FOLDER collects new inputs. An input that crashes is left as crash-*, in the current folder.
if(NOT CS550_FUZZ)
  return()
endif()
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "CS550_FUZZ needs clang++, which has libFuzzer: cmake --preset fuzz")
endif()

add_custom_target(fuzz_targets)
foreach(name scene obj hull mesh)
  set(target fuzz_${name})
  add_executable(${target} EXCLUDE_FROM_ALL "${CMAKE_CURRENT_LIST_DIR}/${target}.cpp")
  target_link_libraries(${target} PRIVATE cs550_scenes cs550_warnings)
  target_link_options(${target} PRIVATE -fsanitize=fuzzer)
  cs550_link_labs(${target} fast reference stub)
  add_dependencies(fuzz_targets ${target})

  set(found "${PROJECT_BINARY_DIR}/fuzz/${name}")
  file(MAKE_DIRECTORY "${found}")
  file(GLOB dictionary "${CMAKE_CURRENT_LIST_DIR}/${name}.dict")
  list(TRANSFORM dictionary PREPEND -dict=)
  add_test(NAME fuzz.${name}
           COMMAND ${target} -max_total_time=15 -timeout=10 -rss_limit_mb=2048 -seed=550 -print_final_stats=1
                   ${dictionary} "-artifact_prefix=${found}-" "${found}"
                   "${CMAKE_CURRENT_LIST_DIR}/corpus/${name}")
  set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz TIMEOUT 120)
endforeach()
