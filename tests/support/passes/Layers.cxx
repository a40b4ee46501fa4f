// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Layers.h"

#include "Check.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPrimitiveIds.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace
{
// Tests of ids are run a second time with another method for all ids.
[[maybe_unused]] const bool Forced = [] {
  const char* route = std::getenv("RELIEVO_TEST_PRIMITIVE_IDS");
  vtkRelievoPrimitiveIds::Force(route ? std::atoi(route) : -1);
  return route != nullptr;
}();
}

namespace relievoTest
{
//------------------------------------------------------------------------------
std::string ToString(Way way)
{
  return way == Way::Own ? "own pass" : "shared pass";
}

//------------------------------------------------------------------------------
Layers::Layers(vtkRenderer* renderer, const std::vector<std::string>& names, Way way,
  const std::function<void(vtkRelievoLayersStage*)>& set)
  : Image(vtkSmartPointer<vtkImageData>::New())
{
  vtkSmartPointer<vtkRelievoPass> before = vtkRelievoPass::SafeDownCast(renderer->GetPass());
  vtkSmartPointer<vtkRelievoPass> pass = vtkRelievoPass::Attach(renderer);
  if (set)
  {
    set(pass->GetLayersStage());
  }
  if (way == Way::Own)
  {
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(renderer);
    for (const std::string& name : names)
    {
      source->AddLayer(name);
    }
    source->Update();
    this->Image->ShallowCopy(source->GetOutput());
  }
  else
  {
    for (const std::string& name : names)
    {
      pass->RequestLayer(name);
    }
    renderer->GetRenderWindow()->Render();
    // Edges of faces extend beyond them, and layers get a separate pass.
    const std::string report = pass->GetFrameReport();
    RELIEVO_CHECK_THAT(pass->GetLayersStage()->GetShared() ||
        report.find("the edges of faces are shown") != std::string::npos,
      "the delegate's geometry pass was not shared: " + report);
    for (const std::string& name : names)
    {
      pass->ReadLayer(name, this->Image);
      pass->ReleaseLayer(name);
    }
  }
  if (!before)
  {
    vtkRelievoPass::Detach(renderer);
  }
  for (const std::string& name : names)
  {
    RELIEVO_CHECK_THAT(this->Image->GetPointData()->GetArray(name.c_str()), "no layer " + name);
  }
  const int* size = this->Image->GetDimensions();
  this->Width = size[0];
  this->Height = size[1];
}

//------------------------------------------------------------------------------
Layers::Layers(vtkImageData* image)
  : Image(image)
{
  const int* size = image->GetDimensions();
  this->Width = size[0];
  this->Height = size[1];
}

//------------------------------------------------------------------------------
double Layers::Value(const std::string& name, int x, int y, int component) const
{
  vtkDataArray* array = this->Image->GetPointData()->GetArray(name.c_str());
  if (!array || component >= array->GetNumberOfComponents())
  {
    Fail(__FILE__, __LINE__, "no component " + std::to_string(component) + " of layer " + name);
    return std::numeric_limits<double>::quiet_NaN();
  }
  return array->GetComponent(static_cast<vtkIdType>(y) * this->Width + x, component);
}

//------------------------------------------------------------------------------
glm::dvec3 Layers::Vector(const std::string& name, int x, int y) const
{
  return { this->Value(name, x, y, 0), this->Value(name, x, y, 1), this->Value(name, x, y, 2) };
}

//------------------------------------------------------------------------------
int Layers::Id(const std::string& name, int x, int y) const
{
  return static_cast<int>(this->Value(name, x, y));
}

//------------------------------------------------------------------------------
long long Layers::CountId(const std::string& name, int id) const
{
  long long count = 0;
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      count += this->Id(name, x, y) == id ? 1 : 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
long long Layers::Covered() const
{
  long long count = 0;
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      count += std::isfinite(this->Value("depth", x, y)) ? 1 : 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
long long CountDifferent(const Layers& a, const Layers& b, const std::string& name)
{
  vtkDataArray* first = a.Image->GetPointData()->GetArray(name.c_str());
  vtkDataArray* second = b.Image->GetPointData()->GetArray(name.c_str());
  if (!first || !second || first->GetNumberOfValues() != second->GetNumberOfValues())
  {
    Fail(__FILE__, __LINE__, "the layers " + name + " cannot be compared");
    return -1;
  }
  long long count = 0;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    bool same = true;
    for (int c = 0; c < first->GetNumberOfComponents(); ++c)
    {
      const double u = first->GetComponent(i, c);
      const double v = second->GetComponent(i, c);
      same = same && (u == v || (std::isnan(u) && std::isnan(v)));
    }
    count += same ? 0 : 1;
  }
  return count;
}

//------------------------------------------------------------------------------
double LargestDifference(const Layers& a, const Layers& b, const std::string& name)
{
  vtkDataArray* first = a.Image->GetPointData()->GetArray(name.c_str());
  vtkDataArray* second = b.Image->GetPointData()->GetArray(name.c_str());
  double largest = CountDifferent(a, b, name) < 0 ? 1e300 : 0.;
  for (vtkIdType i = 0; largest < 1e300 && i < first->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < first->GetNumberOfComponents(); ++c)
    {
      const double u = first->GetComponent(i, c);
      const double v = second->GetComponent(i, c);
      const bool same = u == v || (std::isnan(u) && std::isnan(v));
      const double off = std::abs(u - v);
      largest = std::max(largest, same ? 0. : std::isfinite(off) ? off : 1e300);
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
bool SamePicture(vtkImageData* a, vtkImageData* b, const std::string& what)
{
  vtkDataArray* first = a->GetPointData()->GetScalars();
  vtkDataArray* second = b->GetPointData()->GetScalars();
  if (!first || !second || first->GetNumberOfValues() != second->GetNumberOfValues())
  {
    Fail(__FILE__, __LINE__, what + ": the pictures differ in size");
    return false;
  }
  long long count = 0;
  vtkIdType where = -1;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    bool same = true;
    for (int c = 0; c < first->GetNumberOfComponents(); ++c)
    {
      same = same && first->GetComponent(i, c) == second->GetComponent(i, c);
    }
    where = same || where >= 0 ? where : i;
    count += same ? 0 : 1;
  }
  if (count > 0)
  {
    const int width = a->GetDimensions()[0];
    std::ostringstream out;
    out << what << ": " << count << " pixels differ, the first at (" << where % width << ", "
        << where / width << ")";
    Fail(__FILE__, __LINE__, out.str());
  }
  return count == 0;
}
}
