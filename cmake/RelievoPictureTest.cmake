# A test of a picture, which find_package(Relievo) provides:
#
#   relievo_add_picture_test(
#     NAME name                 name of the test, as for add_test
#     COMMAND command word...   a target or a program, and its words; draws, and writes OUTPUT. It runs in
#                               CMAKE_CURRENT_BINARY_DIR. `Relievo::relievo` is the command relievo
#     BASELINE file             the expected frame, .exr or .png, from CMAKE_CURRENT_SOURCE_DIR
#     [OUTPUT file]             what the command writes, from CMAKE_CURRENT_BINARY_DIR; default: NAME.exr
#     [LIMITS word...])         options of `relievo compare`, such as --levels 3
#
# `relievo compare BASELINE OUTPUT` judges. A test whose pictures differ prints the causes, and tells CDash
# of them and of both pictures, which are beside OUTPUT. Without a baseline it fails.
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
  if (TARGET "${program}") # replaced in the text, as operations on lists split words at their semicolons
    string(REGEX REPLACE "^[^;]+" "$<TARGET_FILE:${program}>" test_COMMAND "${test_COMMAND}")
  endif ()
  add_test(NAME "${test_NAME}"
    COMMAND "${CMAKE_COMMAND}" "-DRELIEVO=$<TARGET_FILE:Relievo::relievo>" "-DBASELINE=${baseline}"
      "-DOUTPUT=${output}" "-DLIMITS=${test_LIMITS}"
      -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/RelievoRunPictureTest.cmake" -- ${test_COMMAND})
endfunction ()
