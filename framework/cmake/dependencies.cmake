# All dependencies are packages of the distribution. Missing ones are reported together, with their
# names in Debian and Ubuntu.
set(missing_packages "")

macro(cs550_require package debian_package)
  find_package(${package} QUIET ${ARGN})
  if(NOT ${package}_FOUND)
    list(APPEND missing_packages ${debian_package})
  endif()
endmacro()

cs550_require(Eigen3 libeigen3-dev 3.4 CONFIG)
cs550_require(GTest libgtest-dev CONFIG)
cs550_require(nlohmann_json nlohmann-json3-dev CONFIG)
cs550_require(CLI11 libcli11-dev CONFIG)
cs550_require(fmt libfmt-dev CONFIG)
cs550_require(tinyobjloader libtinyobjloader-dev CONFIG)
cs550_require(Qhull libqhull-dev CONFIG)
cs550_require(cereal libcereal-dev CONFIG)
cs550_require(Threads libc6-dev)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(ccd QUIET IMPORTED_TARGET ccd)
  if(NOT ccd_FOUND)
    list(APPEND missing_packages libccd-dev)
  endif()
else()
  list(APPEND missing_packages pkg-config libccd-dev)
endif()

if(missing_packages)
  list(JOIN missing_packages " " missing_packages)
  message(FATAL_ERROR "Missing packages. On Debian and Ubuntu:\n  sudo apt install ${missing_packages}\n"
                      "Other systems: see README.md.")
endif()

find_package(benchmark QUIET CONFIG)
