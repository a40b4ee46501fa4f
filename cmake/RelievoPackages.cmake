# Debian packages, made by `cpack -G DEB` in a build with RELIEVO_DEBIAN (docs/packages.md). Each build
# makes its own:
#   on a stand-alone VTK   relievo, libvtkrelievo-dev, python3-relievo
#   on ParaView            paraview-relievo, with its own libraries, for ParaView's VTK is another one

set(RELIEVO_DEBIAN_REVISION 1 CACHE STRING "What follows Relievo's version in the packages' version")
set(RELIEVO_DEBIAN_MAINTAINER "The Relievo authors <relievo@relievo.invalid>" CACHE STRING
  "Whom the packages name as their maintainer, with an address")
set(relievo_debian_version "${PROJECT_VERSION}-${RELIEVO_DEBIAN_REVISION}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME relievo)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "The Relievo authors")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${RELIEVO_DEBIAN_REVISION}")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${RELIEVO_DEBIAN_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SOURCE relievo)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(relievo_about
  "Relievo adds to VTK and ParaView what their OpenGL rendering lacks for\n"
  "scientific work: pictures with depth, normals, positions and ids per\n"
  "pixel, shadows that are correct, and materials.")
string(CONCAT relievo_about ${relievo_about})

# relievo_package(NAME COMPONENTS component... SECTION section SUMMARY text CONTAINS text
#   [DEPENDS package...] [RECOMMENDS package...])
function (relievo_package name)
  cmake_parse_arguments(PARSE_ARGV 1 package "" "SECTION;SUMMARY;CONTAINS" "COMPONENTS;DEPENDS;RECOMMENDS")
  string(MAKE_C_IDENTIFIER "${name}" group)
  set(doc "${CMAKE_INSTALL_DATADIR}/doc/${name}")
  set(own "${CMAKE_CURRENT_BINARY_DIR}/debian/${name}")
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE "${own}/changelog.Debian"
    "relievo (${relievo_debian_version}) unstable; urgency=medium\n\n  * See changelog.gz.\n\n"
    " -- ${RELIEVO_DEBIAN_MAINTAINER}  ${now}\n")
  configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${own}/changelog" COPYONLY)
  execute_process(COMMAND "${RELIEVO_GZIP}" -9nf "${own}/changelog.Debian" "${own}/changelog"
    COMMAND_ERROR_IS_FATAL ANY)
  list(GET package_COMPONENTS 0 first)
  install(FILES "${own}/changelog.Debian.gz" "${own}/changelog.gz"
    DESTINATION "${doc}" COMPONENT "${first}")
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${doc}" RENAME copyright COMPONENT "${first}")

  foreach (component IN LISTS package_COMPONENTS)
    list(APPEND CPACK_COMPONENTS_ALL "${component}")
    string(TOUPPER "${component}" upper)
    set("CPACK_COMPONENT_${upper}_GROUP" "${group}" PARENT_SCOPE)
  endforeach ()
  set(CPACK_COMPONENTS_ALL "${CPACK_COMPONENTS_ALL}" PARENT_SCOPE)
  list(JOIN package_DEPENDS ", " depends)
  list(JOIN package_RECOMMENDS ", " recommends)
  string(TOUPPER "${group}" upper)
  set("CPACK_DEBIAN_${upper}_PACKAGE_NAME" "${name}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_SECTION" "${package_SECTION}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_DESCRIPTION"
    "${package_SUMMARY}\n${relievo_about}\n.\n${package_CONTAINS}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS" "${depends}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS" "${recommends}" PARENT_SCOPE)
endfunction ()

if (RELIEVO_USE_PARAVIEW)
  # ParaView looks for this file beside its programs; Debian's package has none.
  file(RELATIVE_PATH relievo_plugins_file "/${CMAKE_INSTALL_BINDIR}"
    "/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/relievo.plugins.xml")
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/debian/paraview.conf" "${relievo_plugins_file}\n")
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/debian/paraview.conf"
    DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT plugin)
  relievo_package(paraview-relievo
    COMPONENTS plugin runtime
    SECTION science
    SUMMARY "shadows, layers and materials in ParaView"
    CONTAINS "This package has the plugin, which every ParaView program loads when it\nstarts."
    RECOMMENDS python3-paraview libqt5svg5 fonts-dejavu-core)
else ()
  set(relievo_vtk_major "${VTK_MAJOR_VERSION}")
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/debian/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_RELIEVO_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_BINARY_DIR}/debian/triggers")
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
  set(relievo_programs command)
  set(relievo_program_words "the command `relievo`")
  if (TARGET relievo-viewer)
    list(APPEND relievo_programs viewer)
    string(APPEND relievo_program_words ", the window `relievo-viewer`")
  endif ()
  relievo_package(relievo
    COMPONENTS ${relievo_programs} runtime
    SECTION science
    SUMMARY "pictures and measurable layers of meshes and grids"
    CONTAINS "This package has ${relievo_program_words}\nand the libraries."
    RECOMMENDS xvfb xauth libgl1-mesa-dri fonts-dejavu-core)
  relievo_package(libvtkrelievo-dev
    COMPONENTS development
    SECTION libdevel
    SUMMARY "render passes and filters for VTK (development files)"
    CONTAINS "This package has the headers and the files for CMake's\nfind_package(Relievo)."
    # GLM: public headers include it.
    DEPENDS "relievo (= ${relievo_debian_version})" "libvtk${relievo_vtk_major}-dev" libglm-dev)
  if (RELIEVO_WRAP_PYTHON)
    math(EXPR relievo_python_next "${Python3_VERSION_MINOR} + 1")
    relievo_package(python3-relievo
      COMPONENTS python
      SECTION python
      SUMMARY "render passes and filters for VTK (Python)"
      CONTAINS "This package has the Python package `relievo`."
      DEPENDS "relievo (= ${relievo_debian_version})" "python3-vtk${relievo_vtk_major}" python3-numpy
        "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})"
        "python3 (<< ${Python3_VERSION_MAJOR}.${relievo_python_next})")
  endif ()
endif ()

include(CPack)
