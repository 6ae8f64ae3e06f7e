# Everyone who includes a header of the contract agrees on these, or two files read the same struct
# differently (alignment) or compute different bits (contraction).
add_library(cs550_contract INTERFACE)
target_include_directories(cs550_contract INTERFACE "${PROJECT_SOURCE_DIR}/framework/include")
target_link_libraries(cs550_contract INTERFACE Eigen3::Eigen)
target_compile_definitions(cs550_contract INTERFACE EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MPL2_ONLY)
# A compiler cache may hand the compiler relative names.
cmake_path(RELATIVE_PATH PROJECT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_BINARY_DIR}"
           OUTPUT_VARIABLE way_to_root)
target_compile_options(cs550_contract INTERFACE -ffp-contract=off
                       "-ffile-prefix-map=${PROJECT_SOURCE_DIR}/="
                       "-ffile-prefix-map=${way_to_root}/=")

# Our own code.
add_library(cs550_warnings INTERFACE)
target_compile_options(cs550_warnings INTERFACE -Wall -Wextra -Wpedantic
                       $<$<BOOL:${CS550_WERROR}>:-Werror>)

# A lab's functions are all declared in its header: one that is not is a mistyped signature or a
# helper that belongs in an anonymous namespace. For a student it is the only warning that is fatal.
add_library(cs550_student_warnings INTERFACE)
target_compile_options(cs550_student_warnings INTERFACE -Wall -Wextra -Werror=missing-declarations)
# g++ reports such a function under this name, clang++ under -Wmissing-prototypes.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(cs550_student_warnings INTERFACE -Werror=missing-prototypes)
endif()

# A "unique" symbol (a static variable of an inline function) is the one kind that cannot be made
# private to an object file; clang++ never emits it.
add_library(cs550_isolable INTERFACE)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(cs550_isolable INTERFACE -fno-gnu-unique)
endif()

# cs550_precompile(target group header...): only where files are edited and rebuilt all day. The
# targets of a group have the same flags and share what the first of them compiled.
function(cs550_precompile target group)
  if(NOT CS550_PCH)
    return()
  endif()
  get_property(owner GLOBAL PROPERTY cs550_precompiled_${group})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    set_property(GLOBAL PROPERTY cs550_precompiled_${group} ${target})
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
