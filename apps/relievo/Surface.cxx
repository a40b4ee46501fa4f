// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "Readers.h"
#include "Values.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoMaterial.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace cli
{
namespace
{
const std::vector<std::string> Extensions = { ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp",
  ".hdr", ".exr" };

// Without a word about it, relief is this share of the scene's longest side deep.
constexpr double DefaultDepth = 0.02;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadMap(const std::string& path, Progress& progress)
{
  progress.Begin("reading " + path);
  vtkSmartPointer<vtkImageAlgorithm> reader;
  if (ExtensionOf(path) == ".exr")
  {
    auto exr = vtkSmartPointer<vtkRelievoEXRReader>::New();
    exr->SetFileName(path.c_str());
    reader = exr;
  }
  else if (auto* image = vtkImageReader2Factory::CreateImageReader2(path.c_str()))
  {
    reader.TakeReference(image);
    image->SetFileName(path.c_str());
  }
  if (reader)
  {
    progress.Observe(reader);
    reader->Update();
  }
  progress.End();
  vtkSmartPointer<vtkImageData> image = reader ? reader->GetOutput() : nullptr;
  Messages::Check(path, !image || image->GetNumberOfPoints() == 0, NotAsNamed(path));
  return image;
}
}

//------------------------------------------------------------------------------
void CheckMaps(const RenderOptions& options)
{
  for (const auto& [option, path] :
    { std::pair<const char*, std::string>("--normal-map", options.NormalMap),
      std::pair<const char*, std::string>("--height-map", options.HeightMap) })
  {
    if (path.empty())
    {
      continue;
    }
    if (std::find(Extensions.begin(), Extensions.end(), ExtensionOf(path)) == Extensions.end())
    {
      RefuseValue(option, path, "an image: " + Join(Extensions, " "));
    }
    CheckReadable(path);
  }
}

//------------------------------------------------------------------------------
void SetMaps(vtkRenderer* renderer, const RenderOptions& options, Progress& progress)
{
  if (options.NormalMap.empty() && options.HeightMap.empty())
  {
    return;
  }
  vtkNew<vtkRelievoMaterial> material;
  if (!options.NormalMap.empty())
  {
    material->SetNormalMap(ReadMap(options.NormalMap, progress));
  }
  if (!options.HeightMap.empty())
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    const double longest =
      std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    material->SetHeightMap(ReadMap(options.HeightMap, progress));
    material->SetHeightScale(options.HeightScale.value_or(DefaultDepth * longest));
    constexpr int methods[] = { vtkRelievoMaterial::METHOD_OFF, vtkRelievoMaterial::METHOD_PARALLAX,
      vtkRelievoMaterial::METHOD_STEEP, vtkRelievoMaterial::METHOD_OCCLUSION,
      vtkRelievoMaterial::METHOD_RELIEF };
    material->SetMethod(methods[static_cast<int>(options.ReliefMethod)]);
    material->SetDepthCorrection(options.ReliefMethod != Relief::Off);
    material->SetSelfShadow(options.ShadowMethod != Shadows::Off);
  }
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    material->Attach(actor);
  }
}
}
