# Builds the ParaView plugin into <build>/plugin, and installs it where ParaView looks for plugins:
# PV_PLUGIN_PATH may name the build's folder or the installed one, PV_PLUGIN_CONFIG_FILE the
# relievo.plugins.xml beside it; either loads it in every program of ParaView that starts.

# Its part in ParaView's window is built where Qt's developer files are. They are asked for here and
# not through ParaView's component pqComponents, which would ask for those of all its readers too.
set(RELIEVO_PLUGIN_GUI AUTO CACHE STRING
  "The plugin's panel, tool bar and help in ParaView's window: ON, OFF, or AUTO (where Qt is)")
set_property(CACHE RELIEVO_PLUGIN_GUI PROPERTY STRINGS AUTO ON OFF)
set(relievo_plugin_gui OFF)
# ParaView 5.11 and 6 have different major versions of Qt, which ParaView reports since 5.12.
set(relievo_qt_version 5)
if (PARAVIEW_QT_MAJOR_VERSION)
  set(relievo_qt_version "${PARAVIEW_QT_MAJOR_VERSION}")
endif ()
if (RELIEVO_PLUGIN_GUI)
  set(relievo_qt Core Gui Widgets OpenGL)
  find_package("Qt${relievo_qt_version}" QUIET COMPONENTS ${relievo_qt})
  if (Qt${relievo_qt_version}_FOUND AND TARGET ParaView::pqComponents)
    set(relievo_plugin_gui ON)
    add_subdirectory("${PROJECT_SOURCE_DIR}/qt" "${PROJECT_BINARY_DIR}/qt")
    # The linker finds these libraries' own dependencies; CMake would again ask for all readers.
    foreach (target IN ITEMS ParaView::pqWidgets ParaView::pqCore ParaView::pqComponents)
      get_target_property(configurations ${target} IMPORTED_CONFIGURATIONS)
      foreach (configuration IN LISTS configurations)
        set_target_properties(${target} PROPERTIES
          "IMPORTED_LINK_DEPENDENT_LIBRARIES_${configuration}" "")
      endforeach ()
    endforeach ()
  elseif (RELIEVO_PLUGIN_GUI STREQUAL "AUTO")
    message(STATUS "ParaView plugin: for servers and scripts only (no developer files of Qt)")
  else ()
    message(FATAL_ERROR "RELIEVO_PLUGIN_GUI is ON, but the developer files of Qt ${relievo_qt_version} "
      "(${relievo_qt}) or ParaView's Qt libraries were not found. On Debian install qtbase5-dev and "
      "libqt5opengl5-dev, or qt6-base-dev; or set RELIEVO_PLUGIN_GUI=OFF.")
  endif ()
endif ()

# Its pages in ParaView's help need Qt's help generator, and what ParaView makes them with from the XML:
# xmlpatterns in 5, xsltproc in 6.
set(relievo_plugin_help OFF)
if (relievo_plugin_gui)
  if (relievo_qt_version EQUAL 5)
    set(relievo_help_packages "qttools5-dev, qtxmlpatterns5-dev-tools")
    find_package(Qt5Help 5.15 QUIET)
    find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns
      HINTS "${Qt5_DIR}/../../../bin" DOC "Path to xmlpatterns")
    mark_as_advanced(qt_xmlpatterns_executable)
    set(relievo_xml_to_help "${qt_xmlpatterns_executable}")
  else ()
    set(relievo_help_packages "qt6-tools-dev, qt6-documentation-tools, xsltproc")
    find_package(Qt6Tools QUIET)
    find_program(ParaViewClient_xsltproc_executable xsltproc DOC "Path to xsltproc")
    mark_as_advanced(ParaViewClient_xsltproc_executable)
    set(relievo_xml_to_help "${ParaViewClient_xsltproc_executable}")
  endif ()
  set(relievo_xml_to_help_fails 1)
  if (relievo_xml_to_help) # on Debian xmlpatterns may be a broken link
    execute_process(COMMAND "${relievo_xml_to_help}" -version
      RESULT_VARIABLE relievo_xml_to_help_fails OUTPUT_QUIET ERROR_QUIET)
  endif ()
  if (TARGET Qt${relievo_qt_version}::qhelpgenerator AND NOT relievo_xml_to_help_fails)
    set(relievo_plugin_help ON)
  else ()
    message(STATUS "ParaView plugin: without pages in ParaView's help, which need qhelpgenerator and "
      "xmlpatterns or, for ParaView 6, xsltproc (Debian: ${relievo_help_packages})")
  endif ()
endif ()

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/plugin/paraview.plugin"
  ENABLE_BY_DEFAULT ON
  PROVIDES_PLUGINS relievo_plugins)
set(relievo_install_rpath "${CMAKE_INSTALL_RPATH}")
file(RELATIVE_PATH relievo_from_plugin
  "/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Relievo" "/${relievo_library_folder}")
set(CMAKE_INSTALL_RPATH "$ORIGIN/${relievo_from_plugin}" ${relievo_vtk_rpath})
paraview_plugin_build(
  PLUGINS ${relievo_plugins}
  AUTOLOAD ${relievo_plugins}
  PLUGINS_FILE_NAME relievo.plugins.xml
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_COMPONENT plugin
  TARGET_COMPONENT plugin # of the .xml file
  ADD_INSTALL_RPATHS OFF)
set(CMAKE_INSTALL_RPATH "${relievo_install_rpath}")
# The documented place in a build folder: build/NAME/plugin/Relievo.
set(relievo_plugin_folder "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Relievo")
file(MAKE_DIRECTORY "${relievo_plugin_folder}")
file(CREATE_LINK "${relievo_plugin_folder}" "${PROJECT_BINARY_DIR}/plugin/Relievo" SYMBOLIC)
file(CREATE_LINK "${relievo_plugin_folder}/../relievo.plugins.xml"
  "${PROJECT_BINARY_DIR}/plugin/relievo.plugins.xml" SYMBOLIC)
