# The engine as a library for other programs:
#   cmake --install BUILD --prefix PREFIX     then find_package(cs550) and link cs550::cs550
# tests/install/drop_a_box/ is such a program. A students' copy has no complete engine to install.
if(CS550_STUDENTS_COPY)
  return()
endif()
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/cs550")

add_library(cs550_package SHARED ${engine_objects})
target_link_libraries(cs550_package PUBLIC cs550_contract PRIVATE cs550_scenes)
cs550_link_labs(cs550_package fast reference stub)
set_target_properties(cs550_package PROPERTIES OUTPUT_NAME cs550 EXPORT_NAME cs550 INSTALL_RPATH "$ORIGIN"
                      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
get_target_property(libraries cs550_package LINK_LIBRARIES)
if(CS550_ISOLATE_LABS)
  list(FILTER libraries INCLUDE REGEX "^lab")
  target_link_libraries(cs550_package INTERFACE ${libraries})  # programs call their functions, too
else()
  set(libraries "")  # their objects are part of the shared library
endif()

install(TARGETS cs550_package cs550_contract ${libraries} EXPORT cs550 LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT cs550 NAMESPACE cs550:: FILE cs550Targets.cmake DESTINATION "${package_folder}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/framework/include/cs550" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY "${PROJECT_SOURCE_DIR}/framework/assets" DESTINATION "${CMAKE_INSTALL_DATADIR}/cs550")

write_basic_package_version_file("${PROJECT_BINARY_DIR}/cs550ConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_CURRENT_LIST_DIR}/cs550Config.cmake" "${PROJECT_BINARY_DIR}/cs550ConfigVersion.cmake"
        DESTINATION "${package_folder}")
