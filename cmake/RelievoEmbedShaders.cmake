# Script: writes a C++ source that contains every GLSL file as text, so that no GLSL is written in C++.
#   cmake -DOUTPUT=F.cxx -DROOT=DIR -DFILES="a.glsl;b.glsl" -P RelievoEmbedShaders.cmake
set(text "// Made from shaders/*.glsl by cmake/RelievoEmbedShaders.cmake.\n")
string(APPEND text "#include \"vtkRelievoShaderTable.h\"\n")
string(APPEND text "const vtkRelievoShaderTableEntry vtkRelievoShaderTable[] = {\n")
foreach (file IN LISTS FILES)
  file(READ "${ROOT}/${file}" glsl)
  string(APPEND text "{ \"${file}\", R\"GLSL(${glsl})GLSL\" },\n")
endforeach ()
string(APPEND text "{ nullptr, nullptr } };\n")
file(WRITE "${OUTPUT}" "${text}")
