# Every user of a contract header needs these options. Otherwise two files could compute different bits
# (contraction). Within the project, files must also agree on the layout of their own structs (alignment). The
# contract's have no alignment, so programs that embed the engine may choose Eigen's.
add_library(cs550_contract INTERFACE)
target_include_directories(cs550_contract INTERFACE
                           "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/framework/include>")
target_compile_features(cs550_contract INTERFACE cxx_std_20)
target_link_libraries(cs550_contract INTERFACE Eigen3::Eigen)
target_compile_definitions(cs550_contract INTERFACE "$<BUILD_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>"
                           "$<BUILD_INTERFACE:EIGEN_MPL2_ONLY>")
# Other vector code than SSE adds in another order. Without any, summation_order.hpp restores that of SSE.
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86")
  target_compile_definitions(cs550_contract INTERFACE EIGEN_DONT_VECTORIZE)
endif()
# A compiler cache may call the compiler with relative paths.
cmake_path(RELATIVE_PATH PROJECT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_BINARY_DIR}"
           OUTPUT_VARIABLE way_to_root)
target_compile_options(cs550_contract INTERFACE -ffp-contract=off
                       "$<BUILD_INTERFACE:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>"
                       "$<BUILD_INTERFACE:-ffile-prefix-map=${way_to_root}/=>")

# Our own code. Students cannot mend its warnings, and would wait for them.
add_library(cs550_warnings INTERFACE)
if(NOT CS550_STUDENTS_COPY)
  target_compile_options(cs550_warnings INTERFACE -Wall -Wextra -Wpedantic
                         $<$<BOOL:${CS550_WERROR}>:-Werror>)
  # A judge runs given code and tests on what a submission returned: a wrong index must end the test and
  # not read memory.
  target_compile_definitions(cs550_warnings INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
endif()

# All functions of a lab are declared in its header. Another one is a mistyped signature, or a helper
# that belongs in an anonymous namespace. For students only this warning is an error.
add_library(cs550_student_warnings INTERFACE)
target_compile_options(cs550_student_warnings INTERFACE -Wall -Wextra -Werror=missing-declarations)
# g++ reports such a function under this name, clang++ under -Wmissing-prototypes.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(cs550_student_warnings INTERFACE -Werror=missing-prototypes)
endif()

# Finds memory errors and undefined behaviour in code that is compiled with it. With sanitizers, g++
# wrongly warns of uninitialised variables. The presets `asan` and `clang` sanitize everything.
add_library(cs550_sanitizers INTERFACE)
set(sanitizers -fsanitize=address,undefined)
target_compile_options(cs550_sanitizers INTERFACE ${sanitizers} -fno-sanitize-recover=all
                       -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
target_link_options(cs550_sanitizers INTERFACE ${sanitizers})

# A "unique" symbol (a static variable of an inline function) is the only kind that cannot be made
# private to an object file. clang++ never emits one.
add_library(cs550_isolable INTERFACE)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(cs550_isolable INTERFACE -fno-gnu-unique)
endif()

# Precompiled headers, only for files that are edited and rebuilt often.
#   cs550_precompiled_headers(name LIBRARIES library... HEADERS header...)   compiles them once
#   cs550_precompile(target name)       uses them; the target needs the same libraries, and so flags
# Their target compiles nothing else, so that an error in one lab does not block the others.
function(cs550_precompiled_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 argument "" "" "LIBRARIES;HEADERS")
  if(CS550_PCH)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/${name}.cpp" CONTENT "")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/${name}.cpp")
    target_link_libraries(${name} PRIVATE ${argument_LIBRARIES})
    target_precompile_headers(${name} PRIVATE ${argument_HEADERS})
  endif()
endfunction()

function(cs550_precompile target name)
  if(CS550_PCH)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
