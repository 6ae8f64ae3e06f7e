# cs550_gradebook: what `./cs550 grade` does with a class. cs550_grade: the program behind it. CS550_HAS_GRADEBOOK
# is false where its packages are missing, and in a students' copy.
set(CS550_HAS_GRADEBOOK FALSE)
file(GLOB_RECURSE gradebook_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/gradebook/*.cpp")
list(FILTER gradebook_sources EXCLUDE REGEX "/gradebook/program/")
if(gradebook_sources)
  pkg_check_modules(gradebook_packages QUIET IMPORTED_TARGET libarchive tomlplusplus nettle)
  set(CS550_HAS_GRADEBOOK ${gradebook_packages_FOUND})
endif()
if(NOT CS550_HAS_GRADEBOOK)
  return()
endif()

file(GLOB system_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/framework/cli/system/*.cpp")
add_library(cs550_gradebook STATIC EXCLUDE_FROM_ALL ${gradebook_sources} ${system_sources})
target_include_directories(cs550_gradebook PUBLIC "${PROJECT_SOURCE_DIR}/framework")
target_link_libraries(cs550_gradebook
  PUBLIC cs550_contract cs550_files nlohmann_json::nlohmann_json fmt::fmt Threads::Threads
         PkgConfig::gradebook_packages
  PRIVATE cs550_warnings)
cs550_unity(cs550_gradebook 13)

add_executable(cs550_grade "${PROJECT_SOURCE_DIR}/framework/gradebook/program/main.cpp"
               "${PROJECT_SOURCE_DIR}/framework/cli/command_line.cpp")
target_link_libraries(cs550_grade PRIVATE cs550_gradebook CLI11::CLI11 cs550_warnings)
