# Builds the ParaView plugin into <build>/plugin, and installs it where ParaView looks for plugins:
# PV_PLUGIN_PATH may name the build's folder or the installed one.

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/plugin/paraview.plugin"
  ENABLE_BY_DEFAULT ON
  PROVIDES_PLUGINS relievo_plugins)
paraview_plugin_build(
  PLUGINS ${relievo_plugins}
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
# Where people look for it in a build folder: build/NAME/plugin/Relievo.
set(relievo_plugin_folder "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Relievo")
file(MAKE_DIRECTORY "${relievo_plugin_folder}")
file(CREATE_LINK "${relievo_plugin_folder}" "${PROJECT_BINARY_DIR}/plugin/Relievo" SYMBOLIC)
