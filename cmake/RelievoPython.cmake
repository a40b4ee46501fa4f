# Refuses, while configuring, a Python that cannot import the VTK of this build: VTK's modules are
# compiled for one version of Python, and the failure would otherwise show only in the first script.
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${relievo_pythonpath}"
    "${Python3_EXECUTABLE}" -c
    "import vtkmodules.vtkCommonCore as v; print(v.vtkVersion.GetVTKVersion(), end='')"
  OUTPUT_VARIABLE relievo_python_vtk
  ERROR_VARIABLE relievo_python_error
  RESULT_VARIABLE relievo_python_status)
if (relievo_python_status OR NOT relievo_python_vtk STREQUAL VTK_VERSION)
  message(FATAL_ERROR
    "${Python3_EXECUTABLE} does not import the VTK ${VTK_VERSION} that Relievo builds on.\n"
    "It imports: '${relievo_python_vtk}'\n${relievo_python_error}\n"
    "Set Python3_EXECUTABLE to the interpreter that VTK was built for, and PYTHONPATH to VTK's modules.")
endif ()
