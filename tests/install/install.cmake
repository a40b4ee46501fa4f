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

# Picture tests of the installed package: the documentation's example, and failures. A mesh is two triangles.
set(relievo "${here}/prefix/bin/relievo")
set(pictures)
if (EXISTS "${relievo}")
  set(pictures "${here}/pictures")
  file(READ "${PAGE}" page)
  string(REGEX MATCH "```cmake\n([^`]*)```" found "${page}")
  file(WRITE "${pictures}/CMakeLists.txt" "${CMAKE_MATCH_1}include(\"${OUTSIDE}/pictures.cmake\")\n")
  file(WRITE "${pictures}/bunny.off" "OFF\n4 2 0\n-1 0 0\n1 0 0\n0 1 0\n0 -1 0\n3 0 1 2\n3 0 3 1\n")
  file(WRITE "${pictures}/moved/bunny.off"
    "OFF\n4 2 0\n-0.75 0 0\n1.25 0 0\n0.25 1 0\n0.25 -1 0\n3 0 1 2\n3 0 3 1\n")
endif ()

run("configure an outside project" "${CMAKE_COMMAND}" -G Ninja -S "${OUTSIDE}" -B "${here}/build"
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${here}/prefix"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DPICTURES=${pictures}")
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

file(GLOB_RECURSE tests "${here}/prefix/*/RelievoPictureTest.cmake")
file(WRITE "${here}/wrong.cmake" "include(\"${tests}\")\nrelievo_add_picture_test(NAME a BASELINE b.exr)\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -P "${here}/wrong.cmake" ERROR_VARIABLE error RESULT_VARIABLE status)
if (status EQUAL 0 OR NOT error MATCHES "COMMAND is missing")
  message(FATAL_ERROR "a test without a command was not refused: ${status}\n${error}")
endif ()

if (pictures)
  run("the installed command line" "${relievo}" --version)
  set(camera --size 80x60 --camera 0,0,5,0,0,0,0,1,0)
  file(MAKE_DIRECTORY "${pictures}/baselines")
  run("baselines" "${relievo}" render "${pictures}/bunny.off" --baseline "${pictures}/baselines/bunny.exr")
  run("baselines" "${relievo}" render "${pictures}/bunny.off" ${camera}
    --baseline "${pictures}/baselines/moved.exr" --png "${pictures}/baselines/black.png")
  configure_file("${pictures}/baselines/moved.exr" "${here}/build/pictures/old.exr" COPYONLY)
  execute_process(COMMAND "${CMAKE_CTEST_COMMAND}" -T Test -V WORKING_DIRECTORY "${here}/build"
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  foreach (line IN ITEMS
      "bunny \\.+ +Passed" "levels/3 \\.+ +Passed" ", 5 tests failed out of 7"
      "bunny.off \\(actor 0\\) +moved by \\(0.25, 0, 0\\)" "no such baseline: [^\n]*/none.exr"
      "none.off: No such file" "some; words -- [\\]\"'\n" "did not write [^\n]*/old.exr")
    if (NOT output MATCHES "${line}")
      message(FATAL_ERROR "the tests of pictures do not say ${line}:\n${output}")
    endif ()
  endforeach ()
  # The measurements that CDash gets for the two tests with differences.
  file(GLOB results "${here}/build/Testing/*/Test.xml")
  file(READ "${results}" results)
  string(REGEX MATCHALL "type=\"image/png\"|name=\"(ValidImage|TestImage|Causes)\"" sent "${results}")
  list(LENGTH sent number)
  if (NOT number EQUAL 10 OR NOT results MATCHES "<Value>different[^<]*moved by")
    message(FATAL_ERROR "CDash gets ${sent}")
  endif ()
endif ()
