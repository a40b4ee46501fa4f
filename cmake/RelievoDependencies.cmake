# Finds Relievo's dependencies: VTK (ParaView's or a stand-alone one), Python, GLM, OpenEXR, Assimp,
# Draco, nlohmann-json, yaml-cpp, Embree.

set(Python3_FIND_STRATEGY LOCATION)
set(relievo_vtk_components
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  FiltersCore FiltersGeneral FiltersGeometry FiltersHybrid FiltersModeling FiltersSources
  IOExport IOGeometry IOImage IOImport IOLegacy IOPLY IOXML ImagingCore ImagingHybrid
  InteractionStyle
  ParallelCore
  RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2 RenderingVolumeOpenGL2
  WrappingTools
  jpeg png tiff zlib)

if (RELIEVO_USE_PARAVIEW)
  # Named components: without them ParaView also asks for the developer files of Qt, GDAL, FFmpeg
  # and all else that any part of it was built with. Its own list holds a name that VTK thinks old.
  set(relievo_warn_deprecated "${CMAKE_WARN_DEPRECATED}")
  set(CMAKE_WARN_DEPRECATED OFF)
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingServerManager RemotingViews)
  set(CMAKE_WARN_DEPRECATED "${relievo_warn_deprecated}")
endif ()
# After ParaView, VTK_DIR is ParaView's own VTK.
find_package(VTK 9.1 REQUIRED COMPONENTS ${relievo_vtk_components}
  OPTIONAL_COMPONENTS GUISupportQt ImagingStencil WrappingPythonCore Python)

set(RELIEVO_PYTHON_CORE "" CACHE FILEPATH
  "VTK's libvtkWrappingPythonCore for the Python at hand, where VTK's own is for another")
mark_as_advanced(RELIEVO_PYTHON_CORE)
option(RELIEVO_WRAP_PYTHON "Build the Python package; needs a VTK that is wrapped" "${VTK_WRAP_PYTHON}")
if (RELIEVO_WRAP_PYTHON AND NOT VTK_WRAP_PYTHON)
  message(FATAL_ERROR "RELIEVO_WRAP_PYTHON is ON, but the VTK ${VTK_VERSION} in ${VTK_DIR} has no Python "
    "modules. Name a wrapped VTK by VTK_DIR, or set RELIEVO_WRAP_PYTHON to OFF.")
endif ()
# The package of VTK's Python modules: vtkmodules, or that of a VTK of another name.
get_property(relievo_vtk_package TARGET VTK::CommonCore PROPERTY INTERFACE_vtk_module_python_package)
if (NOT relievo_vtk_package)
  set(relievo_vtk_package vtkmodules)
endif ()
if (RELIEVO_WRAP_PYTHON)
  # VTK's Python modules are built for one interpreter, which need not be the first on PATH.
  set(relievo_python_development Development)
  if (SKBUILD) # environments that build wheels have no library of Python
    set(relievo_python_development Development.Module)
  endif ()
  find_package(Python3 REQUIRED COMPONENTS Interpreter ${relievo_python_development})
  if (RELIEVO_PYTHON_CORE) # a VTK SDK is for one version of Python, and this one differs
    set(CVISTA_ABI3 OFF)
    get_filename_component(relievo_python_core "${RELIEVO_PYTHON_CORE}" NAME)
    set_target_properties(VTK::WrappingPythonCore PROPERTIES
      IMPORTED_LOCATION_RELEASE "${RELIEVO_PYTHON_CORE}"
      IMPORTED_SONAME_RELEASE "${relievo_python_core}")
  endif ()
elseif (RELIEVO_BUILD_TESTS)
  find_package(Python3 REQUIRED COMPONENTS Interpreter) # runs the tests of the command line
endif ()
find_package(glm REQUIRED)
# Debian's Imath prints long messages about its Python module, which is not used here.
set(relievo_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
find_package(OpenEXR 3 REQUIRED CONFIG)
set(CMAKE_MESSAGE_LOG_LEVEL "${relievo_log_level}")
find_package(assimp 5.2 REQUIRED)
find_package(draco 1.5 REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(yaml-cpp 0.7 REQUIRED)
if (RELIEVO_BUILD_TESTS OR RELIEVO_BUILD_BENCH)
  find_package(embree 3 REQUIRED)
endif ()

# The PYTHONPATH to import relievo from the build. A VTK unpacked into a folder of its own
# comes with its modules; one installed for the whole machine is on Python's path already.
set(relievo_pythonpath "${CMAKE_BINARY_DIR}/python")
set(relievo_vtk_pythonpath "")
if (NOT VTK_PREFIX_PATH MATCHES "^/usr/?$" AND VTK_PYTHONPATH)
  set(relievo_vtk_pythonpath "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
  string(APPEND relievo_pythonpath ":${relievo_vtk_pythonpath}")
endif ()
