# Script: writes a C++ source that contains a text file as `const char* const NAME`.
#   cmake -DINPUT=FILE -DOUTPUT=F.cxx -DHEADER=F.h -DNAME=space::Name -P RelievoEmbedText.cmake
file(READ "${INPUT}" text)
get_filename_component(file "${INPUT}" NAME)
# Visual C++ limits a literal to 16 380 characters, but joins adjacent literals.
set(literals "")
string(LENGTH "${text}" length)
set(at 0)
while (at LESS length)
  string(SUBSTRING "${text}" ${at} 8000 part)
  string(APPEND literals "R\"TEXT(${part})TEXT\"\n")
  math(EXPR at "${at} + 8000")
endwhile ()
file(WRITE "${OUTPUT}" "// Made from ${file} by cmake/RelievoEmbedText.cmake.
#include \"${HEADER}\"
const char* const ${NAME} = ${literals};
")
