// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfFile.h"

#include "vtkRelievoGltfParts.h"

#include <vtksys/SystemTools.hxx>

namespace relievo
{
//------------------------------------------------------------------------------
bool GetIsGltfExtension(const std::string& path)
{
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
  return extension == ".gltf" || extension == ".glb";
}

//------------------------------------------------------------------------------
void ReadGltf(const std::string& path, const vtkRelievoAllowedFolders& allowed, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model)
{
  GltfDocument document(path, allowed, sources);
  for (const std::string& name : document.GetUnread())
  {
    model.Notes.push_back("uses " + name + ", which is not read");
  }
  const GltfNodes nodes = ReadGltfNodes(document, model);
  ReadGltfMaterials(document, model);
  progress(0.1);
  ReadGltfMeshes(document, nodes, weights, progress, model);
  ReadGltfAnimations(document, nodes, model);
  ReadGltfLightsAndCameras(document, nodes, model);
}
}
