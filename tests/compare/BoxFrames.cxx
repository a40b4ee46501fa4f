// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxFrames.h"

#include "SrgbCurve.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace compareTest
{
namespace
{
struct Hit
{
  int Box = -1, Face = -1;
  double Along = std::numeric_limits<double>::infinity();
};

Hit Shoot(const Boxes& boxes, const Vector& from, const Vector& direction)
{
  Hit nearest;
  for (std::size_t b = 0; b < boxes.All.size(); ++b)
  {
    const Box& box = boxes.All[b];
    if (!box.Visible || box.Translucent)
    {
      continue;
    }
    double in = -1e300, out = 1e300;
    int face = -1;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double middle = box.Center[i] + box.MovedBy[i];
      double t[2] = { (middle - box.HalfSize[i] - from[i]) / direction[i],
        (middle + box.HalfSize[i] - from[i]) / direction[i] };
      const bool turned = t[0] > t[1];
      if (turned)
      {
        std::swap(t[0], t[1]);
      }
      if (t[0] > in)
      {
        in = t[0];
        face = static_cast<int>(2 * i) + (turned ? 1 : 0);
      }
      out = std::min(out, t[1]);
    }
    if (in < out && in > 1e-9 && in < nearest.Along)
    {
      nearest = { static_cast<int>(b), face, in };
    }
  }
  return nearest;
}

template <typename ArrayType>
ArrayType* AddArray(vtkImageData* image, const std::string& name, int components)
{
  vtkNew<ArrayType> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(array);
  return array;
}

void AddDoubles(vtkImageData* image, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  image->GetFieldData()->AddArray(array);
}

void AddStrings(vtkImageData* image, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  image->GetFieldData()->AddArray(array);
}

std::string Join(std::initializer_list<double> numbers)
{
  std::ostringstream out;
  out.precision(17);
  for (const double number : numbers)
  {
    out << (out.tellp() > 0 ? ", " : "") << number;
  }
  return out.str();
}

std::string DescribeBox(const Box& box)
{
  const Vector& m = box.MovedBy;
  Vector c{};
  std::vector<double> bounds;
  for (std::size_t i = 0; i < 3; ++i)
  {
    c[i] = box.Center[i] + m[i];
    bounds.push_back(c[i] - box.HalfSize[i]);
    bounds.push_back(c[i] + box.HalfSize[i]);
  }
  const std::string mesh =
    !box.Mesh.empty() ? box.Mesh : Join({ box.HalfSize[0], box.HalfSize[1], box.HalfSize[2] });
  std::ostringstream out;
  out << R"({"name": ")" << box.Name << R"(", "visible": )" << (box.Visible ? "true" : "false")
      << R"(, "translucent": )" << (box.Translucent ? "true" : "false") << R"(, "matrix": [)"
      << Join({ 1., 0., 0., m[0], 0., 1., 0., m[1], 0., 0., 1., m[2], 0., 0., 0., 1. })
      << R"(], "points": "8 )" << mesh << R"(", "cells": ")" << box.Cells << R"(", "center": [)"
      << Join({ c[0], c[1], c[2] }) << R"(], "bounds": [)"
      << Join({ bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5] })
      << R"(], "spread": [)"
      << Join({ box.HalfSize[0] * box.HalfSize[0], 0., 0., 0., box.HalfSize[1] * box.HalfSize[1],
           0., 0., 0., box.HalfSize[2] * box.HalfSize[2] })
      << R"(], "settings": {"specular": )" << box.Specular << R"(, "point_size": )" << box.PointSize
      << "}" << box.More << "}";
  return out.str();
}
}

//------------------------------------------------------------------------------
Boxes MakeBoxes()
{
  Boxes boxes;
  boxes.All = { { "floor", { 0., -0.1, 0. }, { 2.5, 0.1, 2.5 } },
    { "wheel", { -0.8, 0.4, 0.6 }, { 0.3, 0.4, 0.2 }, { 0.8, 0.2, 0.2 } },
    { "helmet", { 0.6, 0.35, 0.9 }, { 0.4, 0.35, 0.4 }, { 0.2, 0.6, 0.3 } },
    { "cup", { 0.1, 0.25, -1.0 }, { 0.25, 0.25, 0.25 }, { 0.3, 0.3, 0.9 } } };
  boxes.Lamps = { { "key", { 2., 5., 1.5 }, 0.7 }, { "fill", { -3., 4., 2. }, 0.3 } };
  return boxes;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Draw(const Boxes& boxes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(boxes.Width, boxes.Height, 1);
  const Vector target = { 0., 0.3, 0. };
  Vector z{}, x{}, y{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    z[i] = boxes.Eye[i] - target[i];
  }
  vtkMath::Normalize(z.data());
  const Vector up = { 0., 1., 0. };
  vtkMath::Cross(up.data(), z.data(), x.data());
  vtkMath::Normalize(x.data());
  vtkMath::Cross(z.data(), x.data(), y.data());
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * boxes.ViewAngle));
  const double aspect = double(boxes.Width) / boxes.Height;

  auto* color = AddArray<vtkFloatArray>(image, "color", 4);
  auto* depth = AddArray<vtkFloatArray>(image, "depth", 1);
  auto* normal = AddArray<vtkFloatArray>(image, "normal", 3);
  auto* albedo = AddArray<vtkUnsignedCharArray>(image, "albedo", 4);
  auto* actor = AddArray<vtkIntArray>(image, "actor", 1);
  auto* block = AddArray<vtkIntArray>(image, "block", 1);
  auto* cell = AddArray<vtkIntArray>(image, "cell", 1);
  auto* pressure = AddArray<vtkFloatArray>(image, "pressure", 1);
  std::vector<vtkFloatArray*> shadows;
  for (std::size_t i = 0; i < boxes.Lamps.size(); ++i)
  {
    shadows.push_back(AddArray<vtkFloatArray>(image, "shadow_" + std::to_string(i), 1));
  }
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double u = (2. * (double(i % boxes.Width) + 0.5) / boxes.Width - 1.) * tangent * aspect;
    const double v = (2. * (double(i / boxes.Width) + 0.5) / boxes.Height - 1.) * tangent;
    Vector direction{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      direction[c] = u * x[c] + v * y[c] - z[c];
    }
    const Hit hit = Shoot(boxes, boxes.Eye, direction);
    actor->SetValue(i, hit.Box);
    block->SetValue(i, hit.Box < 0 ? -1 : 0);
    cell->SetValue(i, hit.Face);
    depth->SetValue(i, static_cast<float>(hit.Along));
    double n[3] = { 0., 0., 0. };
    double tuple[4] = { 0., 0., 0., 0. };
    pressure->SetValue(i, std::numeric_limits<float>::quiet_NaN());
    if (hit.Box < 0)
    {
      normal->SetTuple(i, n);
      albedo->SetTuple(i, tuple);
      color->SetTuple(i, tuple);
      for (vtkFloatArray* shadow : shadows)
      {
        shadow->SetValue(i, 1.f);
      }
      continue;
    }
    const Box& box = boxes.All[static_cast<std::size_t>(hit.Box)];
    n[hit.Face / 2] = hit.Face % 2 ? 1. : -1.;
    normal->SetTuple(i, n);
    pressure->SetValue(i, static_cast<float>(box.Value));
    Vector place{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      place[c] = boxes.Eye[c] + hit.Along * direction[c];
      tuple[c] = std::round(255. * box.Color[c]);
    }
    tuple[3] = 255.;
    albedo->SetTuple(i, tuple);
    double light = 0.05 + box.Specular;
    for (std::size_t l = 0; l < boxes.Lamps.size(); ++l)
    {
      const Lamp& lamp = boxes.Lamps[l];
      Vector start = place;
      Vector towards = lamp.Direction;
      vtkMath::Normalize(towards.data());
      for (std::size_t c = 0; c < 3; ++c)
      {
        start[c] += 1e-6 * n[c];
      }
      const double facing = vtkMath::Dot(n, towards.data());
      const bool lit = facing > 0. && Shoot(boxes, start, towards).Box < 0;
      shadows[l]->SetValue(i, lit || facing <= 0. ? 1.f : 0.f);
      light += lit ? lamp.Intensity * facing : 0.;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double shown = std::round(255. * std::min(1., light * box.Color[c])) / 255.;
      color->SetComponent(i, static_cast<int>(c), relievoTest::LinearFromSrgb(shown));
    }
    color->SetComponent(i, 3, 1.);
  }
  const auto row = [&](const Vector& axis, double by) {
    return std::vector<double>{ by * axis[0], by * axis[1], by * axis[2],
      -by * vtkMath::Dot(axis.data(), boxes.Eye.data()) };
  };
  std::vector<double> toCamera, toNDC;
  for (const auto& [matrix, rows] :
    { std::pair(&toCamera, std::vector{ row(x, 1.), row(y, 1.), row(z, 1.), { 0., 0., 0., 1. } }),
      std::pair(&toNDC,
        std::vector{
          row(x, 1. / (tangent * aspect)), row(y, 1. / tangent), row(z, -1.), row(z, -1.) }) })
  {
    for (const std::vector<double>& each : rows)
    {
      matrix->insert(matrix->end(), each.begin(), each.end());
    }
  }
  AddDoubles(image, "worldToCamera", toCamera);
  AddDoubles(image, "worldToNDC", toNDC);
  AddDoubles(image, "near", { 1. });
  AddDoubles(image, "far", { 100. });
  std::vector<std::string> lights, objects;
  for (std::size_t l = 0; l < boxes.Lamps.size(); ++l)
  {
    const Lamp& lamp = boxes.Lamps[l];
    lights.push_back(R"({"name": ")" + lamp.Name + R"(", "layer": "shadow_)" + std::to_string(l) +
      R"(", "type": "sun", "position": [)" +
      Join({ lamp.Direction[0], lamp.Direction[1], lamp.Direction[2] }) + R"(], "intensity": )" +
      Join({ lamp.Intensity }) + "}");
  }
  AddStrings(image, "lights", lights);
  if (boxes.HasRecord)
  {
    for (const Box& box : boxes.All)
    {
      objects.push_back(DescribeBox(box));
    }
    vtkNew<vtkIntArray> version;
    version->SetName("baseline_version");
    version->InsertNextValue(3);
    image->GetFieldData()->AddArray(version);
    AddStrings(image, "objects", objects);
    AddStrings(image, "volumes", boxes.Volumes);
    AddStrings(image, "overlays", boxes.Overlays);
    AddStrings(image, "settings", boxes.Settings);
  }
  return image;
}

//------------------------------------------------------------------------------
std::size_t CountDifferent(vtkImageData* a, vtkImageData* b)
{
  std::size_t count = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    bool differs = false;
    for (int k = 0; k < a->GetPointData()->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* from = a->GetPointData()->GetArray(k);
      vtkDataArray* to = b->GetPointData()->GetArray(from->GetName());
      // Other numbers of actors are no difference.
      for (int c = 0; std::string(from->GetName()) != "actor" && c < from->GetNumberOfComponents();
           ++c)
      {
        const double u = from->GetComponent(i, c);
        const double v = to->GetComponent(i, c);
        differs = differs || !(u == v || (std::isnan(u) && std::isnan(v)));
      }
    }
    count += differs ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
void Fill(vtkImageData* image, const char* name, int x0, int x1, int y0, int y1, double value)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        array->SetComponent(y * image->GetDimensions()[0] + x, c, value);
      }
    }
  }
}
}
