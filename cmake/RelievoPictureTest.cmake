# Tests of pictures, for projects that use find_package(Relievo):
#
#   relievo_add_picture_test(
#     NAME name                 name of the test, as for add_test
#     COMMAND command word...   a target or a program, with its arguments, that draws and writes OUTPUT; runs
#                               in CMAKE_CURRENT_BINARY_DIR. `Relievo::relievo` is the command relievo
#     BASELINE file             the expected frame, .exr or .png, in CMAKE_CURRENT_SOURCE_DIR
#     [OUTPUT file]             the file that the command writes, in CMAKE_CURRENT_BINARY_DIR (NAME.exr)
#     [LIMITS word...])         options of `relievo compare`, such as --levels 3
#
# The test runs `relievo compare BASELINE OUTPUT`. If the frames differ, it prints the causes, writes a report
# (OUTPUT with the extension .html), and sends the causes and both pictures, which it writes beside OUTPUT, to
# CDash. It fails without a baseline.
function (relievo_add_picture_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;BASELINE;OUTPUT" "COMMAND;LIMITS")
  foreach (word IN ITEMS NAME COMMAND BASELINE)
    if (NOT test_${word})
      message(FATAL_ERROR "relievo_add_picture_test: ${word} is missing")
    endif ()
  endforeach ()
  if (test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "relievo_add_picture_test(${test_NAME}): unknown words '${test_UNPARSED_ARGUMENTS}'")
  endif ()
  if (NOT TARGET Relievo::relievo)
    message(FATAL_ERROR "relievo_add_picture_test(${test_NAME}): this installation of Relievo has no "
      "command relievo; install its component `command` too")
  endif ()
  if (NOT test_OUTPUT)
    string(REGEX REPLACE "[^A-Za-z0-9_.-]" "_" test_OUTPUT "${test_NAME}.exr")
  endif ()
  get_filename_component(baseline "${test_BASELINE}" ABSOLUTE)
  get_filename_component(output "${test_OUTPUT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  if (output STREQUAL baseline)
    message(FATAL_ERROR "relievo_add_picture_test(${test_NAME}): OUTPUT is the BASELINE, ${baseline}")
  endif ()
  list(GET test_COMMAND 0 program)
  if (TARGET "${program}") # by text, because list operations split words at semicolons
    string(REGEX REPLACE "^[^;]+" "$<TARGET_FILE:${program}>" test_COMMAND "${test_COMMAND}")
  endif ()
  add_test(NAME "${test_NAME}"
    COMMAND "${CMAKE_COMMAND}" "-DRELIEVO=$<TARGET_FILE:Relievo::relievo>" "-DBASELINE=${baseline}"
      "-DOUTPUT=${output}" "-DLIMITS=${test_LIMITS}"
      -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/RelievoRunPictureTest.cmake" -- ${test_COMMAND})
endfunction ()
