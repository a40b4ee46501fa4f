// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerErrors.h"

#include "Check.h"
#include "EmbreeScene.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relievoTest
{
namespace
{
glm::dvec3 Vector(vtkDataArray* array, vtkIdType i)
{
  glm::dvec3 v;
  array->GetTuple(i, &v[0]);
  return v;
}

// OpenGL rounds corners to 1/256 pixel: a triangle of a few such steps may vanish, or not.
const double Sliver = 4. / 256.;

double Quantile(std::vector<double>& values, double share)
{
  if (values.empty())
  {
    return 0.;
  }
  const auto at = values.begin() + static_cast<long>(share * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> CaptureLayers(
  vtkRenderer* renderer, const std::vector<std::string>& layers)
{
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  source->Update();
  vtkSmartPointer<vtkImageData> image = source->GetOutput();
  for (const std::string& layer : layers)
  {
    RELIEVO_CHECK_THAT(image->GetPointData()->GetArray(layer.c_str()), "no layer " + layer);
  }
  return image;
}

//------------------------------------------------------------------------------
LayerErrors CompareLayers(vtkImageData* layers, const EmbreeScene& scene, vtkRenderer* renderer)
{
  const View view(renderer);
  const TruthImage truth = scene.Trace(view);
  glm::dvec3 eye;
  renderer->GetActiveCamera()->GetPosition(&eye[0]);
  vtkPointData* data = layers->GetPointData();
  vtkDataArray* depth = data->GetArray("depth");
  vtkDataArray* range = data->GetArray("range");
  vtkDataArray* face = data->GetArray("geometric_normal");
  vtkDataArray* normal = data->GetArray("normal");
  vtkDataArray* position = data->GetArray("position");
  vtkDataArray* actor = data->GetArray("actor");
  vtkDataArray* cell = data->GetArray("cell");
  LayerErrors errors;
  if (!RELIEVO_CHECK(depth && depth->GetNumberOfTuples() == truth.Width * truth.Height))
  {
    return errors;
  }
  std::vector<double> relative;
  long long uncovered = 0;
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      const vtkIdType i = static_cast<vtkIdType>(y) * truth.Width + x;
      const double drawn = depth->GetComponent(i, 0);
      errors.Compared += pixel.Hit || std::isfinite(drawn);
      uncovered += pixel.Hit != std::isfinite(drawn);
      if (!pixel.Inner || !pixel.Hit || !std::isfinite(drawn))
      {
        continue;
      }
      if (pixel.TriangleWidth < Sliver)
      {
        ++errors.OnSlivers;
        continue;
      }
      relative.push_back(std::abs(drawn - pixel.Depth) / pixel.Depth);
      if (position)
      {
        glm::dvec2 at(0.);
        view.Project(Vector(position, i), at);
        const Ray ray = view.PixelRay(x + 0.5, y + 0.5);
        // Across the view by projection; along it by the depth range of one pixel.
        const Ray next = view.PixelRay(x + 1.5, y + 0.5);
        const double span = glm::length(next.At(pixel.Depth) - ray.At(pixel.Depth));
        const double off = glm::length(Vector(position, i) - pixel.Position) / span;
        errors.PositionMax =
          std::max({ errors.PositionMax, glm::length(at - glm::dvec2(x + 0.5, y + 0.5)), off });
      }
      errors.WrongActors += actor && static_cast<int>(actor->GetComponent(i, 0)) != pixel.Actor;
      const bool inside = pixel.EdgeDistance > 0.01;
      if (cell && inside && static_cast<long long>(cell->GetComponent(i, 0)) != pixel.Cell)
      {
        const SurfacePoint other = scene.Cast(view.PixelRay(x + 0.5, y + 0.5),
          pixel.Depth * (1. - 1e-6), pixel.Depth * (1. + 1e-6), pixel.Triangle);
        errors.WrongCells += !other.Hit;
      }
      if (pixel.TriangleWidth >= 2. && inside)
      {
        if (face)
        {
          errors.FaceNormalMax =
            std::max(errors.FaceNormalMax, AngleDegrees(Vector(face, i), pixel.Normal));
        }
        if (normal)
        {
          errors.NormalMax =
            std::max(errors.NormalMax, AngleDegrees(Vector(normal, i), pixel.Normal));
        }
      }
      if (range)
      {
        const double truly = glm::length(pixel.Position - eye);
        errors.RangeMax =
          std::max(errors.RangeMax, std::abs(range->GetComponent(i, 0) - truly) / truly);
      }
    }
  }
  errors.Coverage =
    static_cast<double>(uncovered) / (static_cast<double>(truth.Width) * truth.Height);
  errors.DepthMax = relative.empty() ? 0. : *std::max_element(relative.begin(), relative.end());
  errors.DepthMedian = Quantile(relative, 0.5);
  errors.DepthP99 = Quantile(relative, 0.99);
  return errors;
}

//------------------------------------------------------------------------------
std::string LayerErrors::ToString() const
{
  std::ostringstream out;
  out << this->Compared << " pixels; coverage differs in " << 100. * this->Coverage
      << " %; on slivers " << this->OnSlivers << "; depth median " << this->DepthMedian << " p99 "
      << this->DepthP99 << " max " << this->DepthMax << "; range max " << this->RangeMax
      << "; face normal max " << this->FaceNormalMax << " deg; normal max " << this->NormalMax
      << " deg; position max " << this->PositionMax << " px; wrong actors " << this->WrongActors
      << ", cells " << this->WrongCells;
  return out.str();
}
}
