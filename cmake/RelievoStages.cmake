# Declares a module of stages, which frames then know by name:
#
#   relievo_add_stages(Relievo::Effects
#     STAGES vtkRelievoHazeStage...     classes that derive from vtkRelievoStage
#     [CLASSES vtkRelievoThing...]      others that are wrapped
#     [NOWRAP_HEADERS file...] [SOURCES file...])
include_guard(GLOBAL)

function (relievo_add_stages module)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "STAGES;CLASSES;NOWRAP_HEADERS;SOURCES")
  if (room_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "relievo_add_stages(${module}): unknown words '${room_UNPARSED_ARGUMENTS}'")
  endif ()
  set_property(GLOBAL APPEND PROPERTY RELIEVO_STAGES ${room_STAGES})
  vtk_module_add_module("${module}"
    CLASSES ${room_STAGES} ${room_CLASSES}
    NOWRAP_HEADERS ${room_NOWRAP_HEADERS}
    SOURCES ${room_SOURCES})
  vtk_module_link("${module}" PRIVATE "$<BUILD_INTERFACE:relievoFormulas>")
endfunction ()
