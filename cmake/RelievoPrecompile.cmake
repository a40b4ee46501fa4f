# Headers of VTK and of the standard library, compiled once for the libraries and once for the tests:
# a third of the time to compile. Off by default, since it hides an #include that a file forgot, which
# tools/check finds; the presets for development turn it on.

option(RELIEVO_PRECOMPILE_HEADERS "Compile the headers of VTK and of the standard library once" OFF)

# No header of VTK's rendering: a macro in each library tells it the object factories.
set(relievo_common_headers
  <algorithm> <array> <cmath> <functional> <limits> <map> <memory> <set> <sstream> <string> <vector>
  <glm/geometric.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp> <glm/vec3.hpp> <glm/vec4.hpp>
  <vtkCellArray.h> <vtkCellData.h> <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h>
  <vtkMath.h> <vtkMatrix4x4.h> <vtkMultiBlockDataSet.h> <vtkNew.h> <vtkObjectFactory.h>
  <vtkPointData.h> <vtkPoints.h> <vtkPolyData.h> <vtkSmartPointer.h>)
set(relievo_rendering_headers
  <iostream> <vtkActor.h> <vtkCamera.h> <vtkLight.h> <vtkPolyDataMapper.h> <vtkProperty.h>
  <vtkRenderWindow.h> <vtkRenderer.h>)

if (RELIEVO_PRECOMPILE_HEADERS)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>") # for the compiler cache
  endif ()
  set(source "${PROJECT_BINARY_DIR}/relievoPrecompiled.cxx")
  file(GENERATE OUTPUT "${source}" CONTENT "int main() {}\n")
  add_library(relievoPrecompiledLibrary STATIC EXCLUDE_FROM_ALL "${source}")
  target_precompile_headers(relievoPrecompiledLibrary PRIVATE ${relievo_common_headers})
  target_link_libraries(relievoPrecompiledLibrary PRIVATE VTK::CommonDataModel glm::glm)
  # Programs are not position independent in the way of libraries.
  add_executable(relievoPrecompiledProgram EXCLUDE_FROM_ALL "${source}")
  target_precompile_headers(relievoPrecompiledProgram PRIVATE
    ${relievo_common_headers} ${relievo_rendering_headers})
  target_link_libraries(relievoPrecompiledProgram PRIVATE VTK::RenderingCore glm::glm)
  set_target_properties(relievoPrecompiledLibrary relievoPrecompiledProgram PROPERTIES
    ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/CMakeFiles"
    RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/CMakeFiles")
endif ()

# Precompiles headers for targets: libraries, or programs without their own object factories.
function (relievo_precompile_headers)
  if (NOT RELIEVO_PRECOMPILE_HEADERS)
    return ()
  endif ()
  foreach (target IN LISTS ARGN)
    get_target_property(aliased "${target}" ALIASED_TARGET)
    if (aliased)
      set(target "${aliased}")
    endif ()
    get_target_property(type "${target}" TYPE)
    if (type STREQUAL "EXECUTABLE")
      target_precompile_headers("${target}" REUSE_FROM relievoPrecompiledProgram)
    else ()
      target_precompile_headers("${target}" REUSE_FROM relievoPrecompiledLibrary)
    endif ()
  endforeach ()
endfunction ()
