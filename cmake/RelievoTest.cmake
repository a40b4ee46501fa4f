# Declares one test:
#
#   relievo_add_test(
#     NAME name                 name of the test and, with SOURCES, of its executable
#     SOURCES a.cxx...          a program with its own main(); links relievoTestSupport
#     | PYTHON script.py        run by the Python that VTK's modules belong to
#     | COMMAND program...      anything else; generator expressions are welcome
#     [LIBRARIES target...]     linked to the program besides relievoTestSupport
#     [PRIVATE_INCLUDES dir...] searched by the program's compiler
#     [ARGS word...]            words of the test's command line
#     [LABELS unit|gl|image|slow|...]   default: unit, or with DISPLAY, which adds it, gl
#     [TIMEOUT seconds]         default: 600; against hanging alone: speed is measured in bench/
#     [DISPLAY]                 needs an X display: the one in DISPLAY, else an Xvfb of its own
#     [OWN_DISPLAY]             with DISPLAY: always an Xvfb of its own (windows that need the keyboard)
#     [SERIAL]                  runs alone (timings)
#     [ENVIRONMENT VAR=value...])
#
# Every test runs in a folder of its own, <build>/Testing/output/<name>, and finds in its environment
#   RELIEVO_TEST_OUTPUT  that folder
#   RELIEVO_DATA         the folder that tools/unpack-data fills
#   RELIEVO_BASELINES    the folder of the expected images
# and what the variable RELIEVO_TEST_ENVIRONMENT lists, as VAR=value.
include_guard(GLOBAL)

set(RELIEVO_DATA "${PROJECT_SOURCE_DIR}/build/data" CACHE PATH
  "Folder of the real meshes, filled by tools/unpack-data")
set(RELIEVO_TEST_LABELS_NOT_BUILT "" CACHE STRING
  "Labels of tests whose programs are built by their names only")
set(RELIEVO_TESTS_NOT_BUILT "" CACHE STRING "Regular expression of names of such tests")
set(RELIEVO_TEST_OUTPUT "${PROJECT_BINARY_DIR}/Testing/output")
set(RELIEVO_BASELINES "${PROJECT_SOURCE_DIR}/tests/baselines")

function (relievo_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "DISPLAY;OWN_DISPLAY;SERIAL" "NAME;PYTHON;TIMEOUT"
    "SOURCES;COMMAND;LIBRARIES;PRIVATE_INCLUDES;ARGS;LABELS;ENVIRONMENT")
  if (test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "relievo_add_test: unknown words '${test_UNPARSED_ARGUMENTS}'")
  endif ()
  if (NOT test_NAME)
    message(FATAL_ERROR "relievo_add_test: NAME is missing")
  endif ()

  if (test_SOURCES)
    add_executable("${test_NAME}" ${test_SOURCES})
    target_link_libraries("${test_NAME}" PRIVATE relievoTestSupport ${test_LIBRARIES})
    relievo_precompile_headers("${test_NAME}")
    target_include_directories("${test_NAME}" PRIVATE ${test_PRIVATE_INCLUDES})
    # A third less to compile, and most of a test's time is spent in libraries.
    target_compile_options("${test_NAME}" PRIVATE "$<$<CONFIG:Release>:-O1>")
    set_target_properties("${test_NAME}" PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests/bin")
    set(command "$<TARGET_FILE:${test_NAME}>")
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

  if (NOT test_LABELS AND NOT test_DISPLAY)
    set(test_LABELS unit)
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
  set(not_built OFF)
  if (RELIEVO_TESTS_NOT_BUILT AND test_NAME MATCHES "${RELIEVO_TESTS_NOT_BUILT}")
    set(not_built ON)
  endif ()
  foreach (label IN LISTS test_LABELS)
    if (label IN_LIST RELIEVO_TEST_LABELS_NOT_BUILT)
      set(not_built ON)
    endif ()
  endforeach ()
  if (test_SOURCES AND not_built)
    set_target_properties("${test_NAME}" PROPERTIES EXCLUDE_FROM_ALL ON)
  endif ()

  set(folder "${RELIEVO_TEST_OUTPUT}/${test_NAME}")
  file(MAKE_DIRECTORY "${folder}")
  add_test(NAME "${test_NAME}" COMMAND ${command} ${test_ARGS} WORKING_DIRECTORY "${folder}")
  set(environment
    "RELIEVO_TEST_OUTPUT=${folder}"
    "RELIEVO_DATA=${RELIEVO_DATA}"
    "RELIEVO_PRESET=none" # VTK's look, which truths are compared with
    "OPENBLAS_NUM_THREADS=1" # of numpy: threads that wait take the core from the test beside
    "RELIEVO_BASELINES=${RELIEVO_BASELINES}"
    ${RELIEVO_TEST_ENVIRONMENT}
    ${test_ENVIRONMENT})
  if (RELIEVO_SANITIZE)
    list(APPEND environment
      "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/lsan.supp:print_suppressions=0"
      "UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1")
  endif ()
  set_tests_properties("${test_NAME}" PROPERTIES
    LABELS "${test_LABELS}"
    TIMEOUT "${test_TIMEOUT}"
    ENVIRONMENT "${environment}"
    RUN_SERIAL "${test_SERIAL}")
endfunction ()
