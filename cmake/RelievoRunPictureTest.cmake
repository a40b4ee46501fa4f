# Script: a test of relievo_add_picture_test. Runs the command after `--`, which writes OUTPUT, and compares
# OUTPUT with BASELINE.
cmake_minimum_required(VERSION 3.20)

# Prints the text with message(), because FATAL_ERROR would wrap its lines.
function (fail text)
  message("${text}")
  message(FATAL_ERROR "The picture test failed.")
endfunction ()

set(command)
set(found FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach (i RANGE ${last})
  if (found)
    string(REPLACE ";" "\\;" word "${CMAKE_ARGV${i}}")
    list(APPEND command "${word}")
  elseif (CMAKE_ARGV${i} STREQUAL "--")
    set(found TRUE)
  endif ()
endforeach ()

# Otherwise an old picture would be compared if the command writes none.
file(REMOVE "${OUTPUT}")
execute_process(COMMAND ${command} RESULT_VARIABLE status)
if (NOT status EQUAL 0)
  fail("The drawing command ended with: ${status}")
endif ()
if (NOT EXISTS "${OUTPUT}")
  fail("The drawing command did not write ${OUTPUT}")
endif ()
set(remedy "If the frame is right, copy ${OUTPUT} to ${BASELINE}")
if (NOT EXISTS "${BASELINE}")
  fail("There is no such baseline: ${BASELINE}\n${remedy}")
endif ()

string(REGEX REPLACE "\\.[^./]*$" "" stem "${OUTPUT}")
set(pngs "${stem}.baseline.png" "${stem}.frame.png")
file(REMOVE ${pngs} "${stem}.html")
list(GET pngs 0 png_a)
list(GET pngs 1 png_b)
execute_process(
  COMMAND "${RELIEVO}" compare "${BASELINE}" "${OUTPUT}" --png-a "${png_a}" --png-b "${png_b}" ${LIMITS}
  RESULT_VARIABLE status OUTPUT_VARIABLE table ECHO_OUTPUT_VARIABLE)
if (status EQUAL 3)
  execute_process( # again, because the report of frames that are alike is not needed
    COMMAND "${RELIEVO}" compare "${BASELINE}" "${OUTPUT}" --html "${stem}.html" ${LIMITS}
    RESULT_VARIABLE status OUTPUT_QUIET)
  set(report)
  if (EXISTS "${stem}.html")
    set(report "; report: ${stem}.html")
  endif ()
  set(tag CTest)
  if (CMAKE_VERSION VERSION_LESS 3.21)
    set(tag Dart)
  endif ()
  string(REPLACE "&" "&amp;" table "${table}")
  string(REPLACE "<" "&lt;" table "${table}")
  # CDash shows pictures with these names together, one over the other.
  message("<${tag}Measurement name=\"Causes\" type=\"text/preformatted\">${table}</${tag}Measurement>\n"
    "<${tag}MeasurementFile name=\"ValidImage\" type=\"image/png\">${png_a}</${tag}MeasurementFile>\n"
    "<${tag}MeasurementFile name=\"TestImage\" type=\"image/png\">${png_b}</${tag}MeasurementFile>")
  fail("The frame differs from the baseline${report}\n${remedy}")
elseif (NOT status EQUAL 0)
  fail("relievo compare ended with: ${status}")
endif ()
