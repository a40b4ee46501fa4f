// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshNames.h"

#include "Errors.h"
#include "Readers.h"
#include "Values.h"

namespace cli
{
//------------------------------------------------------------------------------
void CheckMeshName(const std::string& option, const std::string& name)
{
  if (scene::ExtensionOf(name) != ".vtp")
  {
    scene::RefuseValue(option, name, "a name that ends in .vtp");
  }
}

//------------------------------------------------------------------------------
void CheckMeshFiles(
  const std::string& command, const std::vector<std::string>& files, const std::string& output)
{
  if (files.empty())
  {
    throw scene::UsageError(command + ": no FILE given");
  }
  for (const std::string& file : files)
  {
    if (scene::IsModel(file))
    {
      throw scene::UsageError(file + ": a model, expected data, such as .vtp, .vtu, .obj or .stl");
    }
    scene::CheckExtension(file);
  }
  if (output.empty())
  {
    throw scene::UsageError(command + ": no file to write; give -o FILE.vtp");
  }
  CheckMeshName("-o", output);
}
}
