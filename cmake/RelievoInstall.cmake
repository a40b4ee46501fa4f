# Files that `find_package(Relievo)` reads, in the build and after `cmake --install`.
include(CMakePackageConfigHelpers)

# Short names of the VTK modules that Relievo's need.
set(relievo_needed_vtk)
foreach (module IN LISTS relievo_modules)
  foreach (property IN ITEMS depends private_depends)
    get_property(names TARGET "${module}" PROPERTY "INTERFACE_vtk_module_${property}")
    list(FILTER names INCLUDE REGEX "^VTK::")
    list(TRANSFORM names REPLACE "^VTK::" "")
    list(APPEND relievo_needed_vtk ${names})
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES relievo_needed_vtk)
list(SORT relievo_needed_vtk)

string(REPLACE "Relievo::" "" relievo_component_names "${relievo_modules}")
list(JOIN relievo_component_names " " relievo_component_names)

# A package is used on another machine, where VTK is in the system's folders.
set(relievo_vtk_hint)
if (NOT RELIEVO_DEBIAN)
  set(relievo_vtk_hint "HINTS \"${VTK_DIR}\"")
endif ()

set(relievo_cmake "${CMAKE_INSTALL_LIBDIR}/cmake/relievo")
configure_package_config_file(cmake/RelievoConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${relievo_cmake}/RelievoConfig.cmake"
  INSTALL_DESTINATION "${relievo_cmake}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${relievo_cmake}/RelievoConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
foreach (file IN ITEMS RelievoPictureTest.cmake RelievoRunPictureTest.cmake)
  configure_file("cmake/${file}" "${CMAKE_BINARY_DIR}/${relievo_cmake}/${file}" COPYONLY)
endforeach ()
install(FILES
  "${CMAKE_BINARY_DIR}/${relievo_cmake}/RelievoConfig.cmake"
  "${CMAKE_BINARY_DIR}/${relievo_cmake}/RelievoConfigVersion.cmake"
  cmake/RelievoPictureTest.cmake
  cmake/RelievoRunPictureTest.cmake
  DESTINATION "${relievo_cmake}" COMPONENT development)
if (NOT RELIEVO_DEBIAN AND NOT SKBUILD)
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT runtime)
endif ()

# Programs find the libraries of their own prefix, even if it is moved.
if (SKBUILD)
  string(REPLACE "$ORIGIN" "$ORIGIN/.." relievo_vtk_rpath "${relievo_vtk_rpath}")
  set(CMAKE_INSTALL_RPATH "$ORIGIN/.." ${relievo_vtk_rpath})
else ()
  set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}" ${relievo_vtk_rpath})
endif ()
