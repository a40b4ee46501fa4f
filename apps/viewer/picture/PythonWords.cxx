// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonWords.h"

#include "Failure.h"
#include "Readers.h"
#include "Settings.h"

#include <cstdio>

namespace viewer
{
//------------------------------------------------------------------------------
void RefusePython(const std::string& what)
{
  throw cli::WorkError(
    "Copy as Python: " + what + " cannot be said there yet; Copy as command line says it");
}

//------------------------------------------------------------------------------
std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    quoted +=
      letter == '"' || letter == '\\' ? std::string(1, '\\') + letter : std::string(1, letter);
  }
  return quoted + "\"";
}

//------------------------------------------------------------------------------
std::string QuoteBytes(const std::string& text)
{
  std::string quoted = "b\"";
  for (const char letter : text)
  {
    const bool plain = letter >= ' ' && letter <= '~' && letter != '"' && letter != '\\';
    char number[5];
    std::snprintf(number, sizeof number, "\\x%02x", static_cast<unsigned char>(letter));
    quoted += plain ? std::string(1, letter) : number;
  }
  return quoted + "\"";
}

//------------------------------------------------------------------------------
std::string WriteThree(const double* values)
{
  return WriteNumbers({ values[0], values[1], values[2] });
}

//------------------------------------------------------------------------------
const char* GetReader(const std::string& path)
{
  const std::string extension = cli::ExtensionOf(path);
  if (cli::IsGLTF(path) || cli::IsModel(path))
  {
    RefusePython(path);
  }
  return extension == ".stl" ? "vtkSTLReader"
    : extension == ".ply"    ? "vtkPLYReader"
    : extension == ".obj"    ? "vtkOBJReader"
    : extension == ".off"    ? "relievo.vtkRelievoOFFReader"
    : extension == ".vtk"    ? "vtkGenericDataObjectReader"
                             : "vtkXMLGenericDataObjectReader";
}
}
