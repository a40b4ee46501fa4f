# Script: makes the pictures of failed comparisons the new baselines. Look at them first.
#   cmake -DFROM=<build>/Testing/output -DTO=<source>/tests/baselines -P RelievoUpdateBaselines.cmake
# The environment variable RELIEVO_TESTS, a regular expression, limits it to tests of that name.
file(GLOB_RECURSE pictures RELATIVE "${FROM}" "${FROM}/*.actual.png")
set(count 0)
foreach (picture IN LISTS pictures)
  get_filename_component(test "${picture}" DIRECTORY)
  # The comparator's own tests fail on purpose.
  if (test MATCHES "^testImage(Compare|Tools)" OR NOT test MATCHES "$ENV{RELIEVO_TESTS}")
    continue ()
  endif ()
  get_filename_component(name "${picture}" NAME)
  string(REGEX REPLACE "\\.actual\\.png$" ".png" name "${name}")
  configure_file("${FROM}/${picture}" "${TO}/${name}" COPYONLY)
  message(STATUS "${picture} -> ${TO}/${name}")
  math(EXPR count "${count} + 1")
endforeach ()
message(STATUS "${count} baseline(s) written")
