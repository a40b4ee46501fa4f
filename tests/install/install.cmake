# Script: installs BUILD into a prefix, moves the prefix, and uses it from outside.
# Works in the current folder. Every step that fails stops it with that step's output.
function (run words)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if (NOT status EQUAL 0)
    message(FATAL_ERROR "${words}: status ${status}\n${output}")
  endif ()
  message(STATUS "${words}")
  set(output "${output}" PARENT_SCOPE)
endfunction ()

set(here "${CMAKE_CURRENT_BINARY_DIR}")
file(REMOVE_RECURSE "${here}/first" "${here}/prefix" "${here}/build")
run("install" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${here}/first")
file(RENAME "${here}/first" "${here}/prefix")

# No file of the prefix may name the source or the build, or it works on this machine only.
file(GLOB_RECURSE texts
  "${here}/prefix/*.cmake" "${here}/prefix/*.py" "${here}/prefix/*.h" "${here}/prefix/*.txt")
foreach (text IN LISTS texts)
  file(STRINGS "${text}" named REGEX "${BUILD}/(passes|io|lib/lib)")
  if (named)
    message(FATAL_ERROR "${text} names the build folder:\n${named}")
  endif ()
endforeach ()

run("configure an outside project" "${CMAKE_COMMAND}" -G Ninja -S "${OUTSIDE}" -B "${here}/build"
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${here}/prefix"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run("build it" "${CMAKE_COMMAND}" --build "${here}/build")
run("run it" "${here}/build/outside" "${here}/outside.exr")
message(STATUS "${output}")
run("its libraries" ldd "${here}/build/outside")
string(REGEX MATCHALL "libvtkRelievo[^\n]*" lines "${output}")
foreach (line IN LISTS lines)
  string(FIND "${line}" "${here}/prefix/${LIBDIR}/" found)
  if (found EQUAL -1)
    message(FATAL_ERROR "not from the prefix: ${line}")
  endif ()
endforeach ()
if (NOT lines)
  message(FATAL_ERROR "the outside program links no library of Relievo:\n${output}")
endif ()

if (PYTHON)
  file(READ "${here}/build/pythonpath" pythonpath)
  run("an outside script" "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${pythonpath}:${VTK_PYTHONPATH}" ${PYTHON_ENVIRONMENT}
    "${PYTHON}" "${OUTSIDE}/outside.py" "${here}/script.exr" "${here}/prefix")
  message(STATUS "${output}")
endif ()

# A component that does not exist is refused by its name.
file(WRITE "${here}/wrong/CMakeLists.txt"
  "cmake_minimum_required(VERSION 3.20)\nproject(W LANGUAGES CXX)\n"
  "find_package(Relievo REQUIRED COMPONENTS Passes Teapots)\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -G Ninja -S "${here}/wrong" -B "${here}/wrong/build"
  "-DCMAKE_PREFIX_PATH=${here}/prefix" OUTPUT_QUIET ERROR_VARIABLE error RESULT_VARIABLE status)
if (status EQUAL 0 OR NOT error MATCHES "no component 'Teapots'")
  message(FATAL_ERROR "a wrong component was not refused by its name: ${status}\n${error}")
endif ()

if (EXISTS "${here}/prefix/bin/relievo")
  run("the installed command line" "${here}/prefix/bin/relievo" --version)
endif ()
