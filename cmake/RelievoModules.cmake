# Scans and builds Relievo's VTK modules; each links only what its vtk.module names.

include(RelievoStages)
set(relievo_rooms base base/gl describe shaders layers cameras rays passes/frame passes/gbuffer
  passes/volumes passes/shadows passes/deferred passes/effects passes materials io filters animation
  compare reading look scene dataset)
set(relievo_module_files ${relievo_rooms})
list(TRANSFORM relievo_module_files REPLACE "(.+)" "${CMAKE_CURRENT_SOURCE_DIR}/\\1/vtk.module")
set(relievo_requested Relievo::Base Relievo::BaseGL Relievo::Describe Relievo::Shaders Relievo::Layers
  Relievo::Cameras Relievo::Rays Relievo::Passes Relievo::Materials Relievo::IO Relievo::Filters
  Relievo::Animation Relievo::Compare Relievo::Reading Relievo::Look Relievo::Scene Relievo::Dataset)
# Modules of ParaView's plugin: not for Python, which uses ParaView's server manager.
set(relievo_plugin_modules)
if (RELIEVO_USE_PARAVIEW)
  set(relievo_plugin_modules Relievo::PluginServer)
  list(APPEND relievo_requested ${relievo_plugin_modules})
  list(APPEND relievo_module_files "${CMAKE_CURRENT_SOURCE_DIR}/plugin/server/vtk.module")
endif ()
vtk_module_scan(
  MODULE_FILES ${relievo_module_files}
  REQUEST_MODULES ${relievo_requested}
  PROVIDES_MODULES relievo_modules
  ENABLE_TESTS OFF)
# Packages of both builds can be installed side by side: the libraries on ParaView's VTK have the names of
# those on the stand-alone VTK, and lie in a folder of their own.
set(relievo_library_folder "${CMAKE_INSTALL_LIBDIR}")
if (RELIEVO_DEBIAN AND RELIEVO_USE_PARAVIEW)
  set(relievo_library_folder "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/../relievo")
  cmake_path(NORMAL_PATH relievo_library_folder)
endif ()
set(relievo_library_version
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
if (SKBUILD) # a wheel would contain three copies instead of links
  set(relievo_library_version)
endif ()
# VTK 9.4 and later warn, at length, of headers in folders, which CMake might install with these folders
# one day: not unless a build asks for it (USE_FILE_SETS).
set(CMAKE_SUPPRESS_DEVELOPER_WARNINGS ON)
vtk_module_build(
  MODULES ${relievo_modules}
  PACKAGE Relievo
  INSTALL_EXPORT Relievo
  INSTALL_HEADERS ON
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/relievo"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/relievo"
  LIBRARY_DESTINATION "${relievo_library_folder}"
  HIERARCHY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/relievo/hierarchy"
  TEST_DIRECTORY_NAME NONE
  ${relievo_library_version})
unset(CMAKE_SUPPRESS_DEVELOPER_WARNINGS)
relievo_relative_autoinit(${relievo_modules})
list(REMOVE_ITEM relievo_modules ${relievo_plugin_modules})
# Not the four modules without VTK's data: their macros differ.
set(relievo_of_data ${relievo_modules})
list(REMOVE_ITEM relievo_of_data Relievo::Base Relievo::Describe Relievo::Shaders Relievo::Layers)
relievo_precompile_headers(${relievo_of_data})
# A quarter of the time to compile. Off by default: it hides an #include that a file forgot, and one
# changed file compiles eight. Names in one target's unnamed namespaces must differ for it; those of
# Materials, the marks of its shaders, do not.
option(RELIEVO_UNITY_BUILD "Compile the sources of libraries, programs and plugin several at once" OFF)
if (RELIEVO_UNITY_BUILD)
  foreach (module IN LISTS relievo_modules relievo_plugin_modules)
    get_target_property(target "${module}" ALIASED_TARGET)
    if (NOT module STREQUAL "Relievo::Materials")
      set_target_properties("${target}" PROPERTIES UNITY_BUILD ON)
    endif ()
  endforeach ()
endif ()
