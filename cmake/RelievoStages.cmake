# Declares a module of stages, which frames find by name:
#
#   relievo_add_stages(Relievo::Effects
#     STAGES [folder/]vtkRelievoHazeStage...  classes that derive from vtkRelievoStage
#     [CLASSES [folder/]vtkRelievoThing...]   others that are wrapped
#     [NOWRAP_HEADERS file...] [SOURCES file...])
include_guard(GLOBAL)

function (relievo_add_stages module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "STAGES;CLASSES;NOWRAP_HEADERS;SOURCES")
  if (arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "relievo_add_stages(${module}): unknown words '${arg_UNPARSED_ARGUMENTS}'")
  endif ()
  foreach (stage IN LISTS arg_STAGES)
    cmake_path(GET stage FILENAME name)
    set_property(GLOBAL APPEND PROPERTY RELIEVO_STAGES "${name}")
  endforeach ()
  vtk_module_add_module("${module}"
    CLASSES ${arg_STAGES} ${arg_CLASSES}
    NOWRAP_HEADERS ${arg_NOWRAP_HEADERS}
    SOURCES ${arg_SOURCES})
  vtk_module_link("${module}" PRIVATE "$<BUILD_INTERFACE:relievoFormulas>")
endfunction ()

# The folders of a module's files: on the include path of the module and, in this build, of targets
# that link it, or, after PRIVATE, of the module alone. Installed headers are in one folder.
function (relievo_module_folders module)
  cmake_parse_arguments(PARSE_ARGV 1 folders "" "" "PRIVATE")
  foreach (folder IN LISTS folders_UNPARSED_ARGUMENTS)
    vtk_module_include("${module}" PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
  endforeach ()
  foreach (folder IN LISTS folders_PRIVATE)
    vtk_module_include("${module}" PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/${folder}")
  endforeach ()
endfunction ()
