# Declares one test:
#
#   relievo_add_test(
#     NAME name                 name of the test
#     SOURCES a.cxx...          the case of a.cxx (TestCase.h) in the program of the folder, which is built
#                               of all sources that its tests name, and links relievoTestSupport
#     | PYTHON script.py        run by the Python that VTK's modules belong to
#     | COMMAND program...      anything else; generator expressions are welcome
#     [LIBRARIES target...]     linked to the folder's program besides relievoTestSupport
#     [PRIVATE_INCLUDES dir...] searched by its compiler
#     [ARGS word...]            words of the test's command line
#     [LABELS unit|gl|image|slow|...]   default: unit, or with DISPLAY, which adds it, gl
#     [TIMEOUT seconds]         default: 600; against hanging alone: speed is measured in bench/
#     [DISPLAY]                 needs an X display: the one in DISPLAY, else an Xvfb of its own
#     [OWN_DISPLAY]             with DISPLAY: always an Xvfb of its own (windows that need the keyboard)
#     [SERIAL]                  runs alone (timings)
#     [ENVIRONMENT VAR=value...])
#
# The program of tests/shadows is tests/bin/relievo_tests_shadows; `--all` runs all its cases.
# Every test runs in a folder of its own, <build>/Testing/output/<name>, where it leaves the processor
# seconds it took (tools/test-times), and finds in its environment
#   RELIEVO_TEST_OUTPUT  that folder
#   RELIEVO_DATA         the folder that tools/unpack-data fills
# and what the variable RELIEVO_TEST_ENVIRONMENT lists, as VAR=value.
include_guard(GLOBAL)

set(RELIEVO_DATA "${PROJECT_SOURCE_DIR}/build/data" CACHE PATH
  "Folder of the real meshes, filled by tools/unpack-data")
set(RELIEVO_TESTS_LEFT_OUT "" CACHE STRING
  "Labels of tests that this build does without, such as `once`; their sources are not compiled")
set(RELIEVO_TEST_OUTPUT "${PROJECT_BINARY_DIR}/Testing/output")
set(relievo_test_seconds "${PROJECT_SOURCE_DIR}/tests/seconds.csv")

# Adds the sources to the program of the current folder, once each, and returns its name.
function (relievo_test_program result)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/tests"
    OUTPUT_VARIABLE folder)
  string(REPLACE "/" "_" program "relievo_tests_${folder}")
  set("${result}" "${program}" PARENT_SCOPE)
  if (NOT TARGET "${program}")
    add_executable("${program}")
    target_link_libraries("${program}" PRIVATE relievoTestMain relievoTestSupport)
    relievo_precompile_headers("${program}")
    # Compiles in a third less time, and most of a test's time is spent in libraries.
    target_compile_options("${program}" PRIVATE "$<$<CONFIG:Release>:-O1>")
    set_target_properties("${program}" PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests/bin"
      UNITY_BUILD ON)
  endif ()
  get_target_property(present "${program}" SOURCES)
  foreach (source IN LISTS ARGN)
    if (NOT source IN_LIST present)
      target_sources("${program}" PRIVATE "${source}")
    endif ()
  endforeach ()
endfunction ()

function (relievo_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "DISPLAY;OWN_DISPLAY;SERIAL" "NAME;PYTHON;TIMEOUT"
    "SOURCES;COMMAND;LIBRARIES;PRIVATE_INCLUDES;ARGS;LABELS;ENVIRONMENT")
  if (test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "relievo_add_test: unknown words '${test_UNPARSED_ARGUMENTS}'")
  endif ()
  if (NOT test_NAME)
    message(FATAL_ERROR "relievo_add_test: NAME is missing")
  endif ()

  if (NOT test_LABELS AND NOT test_DISPLAY)
    set(test_LABELS unit)
  endif ()
  foreach (label IN LISTS test_LABELS)
    if (label IN_LIST RELIEVO_TESTS_LEFT_OUT)
      return ()
    endif ()
  endforeach ()

  if (test_SOURCES)
    list(GET test_SOURCES 0 case)
    get_filename_component(case "${case}" NAME_WE)
    relievo_test_program(program ${test_SOURCES})
    target_link_libraries("${program}" PRIVATE ${test_LIBRARIES})
    target_include_directories("${program}" PRIVATE ${test_PRIVATE_INCLUDES})
    set(command "$<TARGET_FILE:${program}>" --case "${case}")
    list(APPEND test_ENVIRONMENT "RELIEVO_READ_HERE=1") # so that a reader's crash fails the test
  elseif (test_PYTHON)
    get_filename_component(script "${test_PYTHON}" ABSOLUTE)
    set(command "${Python3_EXECUTABLE}" "${script}")
    list(APPEND test_ENVIRONMENT
      "PYTHONPATH=${relievo_pythonpath}:${PROJECT_SOURCE_DIR}/tests/support/truth")
  elseif (test_COMMAND)
    set(command ${test_COMMAND})
  else ()
    message(FATAL_ERROR "relievo_add_test(${test_NAME}): give SOURCES, PYTHON or COMMAND")
  endif ()

  if (test_DISPLAY)
    if (test_OWN_DISPLAY)
      list(PREPEND command --own)
    endif ()
    list(PREPEND command "${PROJECT_SOURCE_DIR}/tools/with-display")
    list(APPEND test_LABELS gl)
    list(REMOVE_DUPLICATES test_LABELS)
  endif ()
  if (NOT test_TIMEOUT)
    set(test_TIMEOUT 600)
  endif ()

  set(folder "${RELIEVO_TEST_OUTPUT}/${test_NAME}")
  file(MAKE_DIRECTORY "${folder}")
  add_test(NAME "${test_NAME}"
    COMMAND "${PROJECT_SOURCE_DIR}/tools/count-seconds" "${folder}/seconds" ${command} ${test_ARGS}
    WORKING_DIRECTORY "${folder}")
  set(environment
    "RELIEVO_TEST_OUTPUT=${folder}"
    "RELIEVO_DATA=${RELIEVO_DATA}"
    "RELIEVO_PRESET=none" # VTK's look, for comparisons with truths
    "OPENBLAS_NUM_THREADS=1" # of numpy: waiting threads occupy other tests' cores
    ${RELIEVO_TEST_ENVIRONMENT}
    ${test_ENVIRONMENT})
  if (RELIEVO_SANITIZE)
    list(APPEND environment
      "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/lsan.supp:print_suppressions=0"
      "UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1")
  endif ()
  # Longer tests start first, so that no core waits at the end.
  set(cost 5) # of new ones
  file(STRINGS "${relievo_test_seconds}" row REGEX "^${test_NAME},")
  if (row MATCHES ",([0-9.]+)$")
    set(cost "${CMAKE_MATCH_1}")
  endif ()
  set_tests_properties("${test_NAME}" PROPERTIES
    COST "${cost}"
    LABELS "${test_LABELS}"
    TIMEOUT "${test_TIMEOUT}"
    ENVIRONMENT "${environment}"
    RUN_SERIAL "${test_SERIAL}")
endfunction ()
