// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonWords.h"

#include "Errors.h"
#include "Readers.h"
#include "Settings.h"

#include <QString>

#include <cstdio>

namespace viewer
{
namespace
{
std::string QuoteLetters(const std::string& text, bool (*isPlain)(unsigned char))
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    const auto byte = static_cast<unsigned char>(letter);
    char number[5];
    std::snprintf(number, sizeof number, "\\x%02x", byte);
    const bool plain = isPlain(byte) && letter != '"' && letter != '\\';
    quoted += plain ? std::string(1, letter) : number;
  }
  return quoted + "\"";
}
}

//------------------------------------------------------------------------------
void RefusePython(const std::string& what)
{
  throw cli::WorkError(
    "Copy as Python: " + what + " cannot be said there yet; Copy as command line says it");
}

//------------------------------------------------------------------------------
std::string Quote(const std::string& text)
{
  if (QString::fromStdString(text).toStdString() != text)
  {
    RefusePython("the name " + QuoteBytes(text) + ", which is not UTF-8,");
  }
  return QuoteLetters(text, [](unsigned char letter) { return letter >= ' ' && letter != 0x7f; });
}

//------------------------------------------------------------------------------
std::string QuoteBytes(const std::string& text)
{
  return "b" +
    QuoteLetters(text, [](unsigned char letter) { return letter >= ' ' && letter <= '~'; });
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
