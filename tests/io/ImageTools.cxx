// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageTools.h"

#include "vtkRelievoEXRReader.h"
#include "vtkRelievoEXRWriter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace ioTest
{
namespace
{
const double Infinity = std::numeric_limits<double>::infinity();
const double NaN = std::numeric_limits<double>::quiet_NaN();

// A different number with few trailing zero bits for every point and component.
double Wave(int point, int component)
{
  return std::sin(0.7 * point + 1.3 * component + 0.1) * std::exp(0.01 * (point % 40));
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeImage(int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  return image;
}

//------------------------------------------------------------------------------
vtkDataArray* AddArray(vtkImageData* image, const std::string& name, int vtkType, int components,
  const std::function<double(int, int)>& value)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkType));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, value(static_cast<int>(i), c));
    }
  }
  image->GetPointData()->AddArray(array);
  return array;
}

//------------------------------------------------------------------------------
void AddField(vtkImageData* image, const std::string& name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_DOUBLE));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.data());
  image->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddStrings(
  vtkImageData* image, const std::string& name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  image->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeLayers(int width, int height)
{
  auto image = MakeImage(width, height);
  const auto background = [](int i) { return i % 7 == 3; };
  const double origin[3] = { 500000.125, 5000000.1, 0.3 };
  AddArray(image, "color", VTK_FLOAT, 4, [](int i, int c) { return std::abs(Wave(i, c)) * 3; });
  for (const char* name : { "depth", "range" })
  {
    AddArray(image, name, VTK_FLOAT, 1, [&](int i, int) {
      return background(i) ? Infinity : i == 5 ? NaN : 10 + Wave(i, 0);
    });
  }
  for (const char* name : { "normal", "geometric_normal" })
  {
    AddArray(image, name, VTK_FLOAT, 3, [&](int i, int c) {
      return background(i) ? 0 : i == 6 ? -0.0 : Wave(i, c);
    });
  }
  AddArray(image, "position", VTK_DOUBLE, 3, [&](int i, int c) {
    return background(i) ? 0.0 : origin[c] + static_cast<double>(static_cast<float>(Wave(i, c)));
  });
  AddArray(
    image, "albedo", VTK_UNSIGNED_CHAR, 4, [](int i, int c) { return (i * 7 + c * 61) % 256; });
  const double ids[] = { -1, 0, 1, 2147483647, -2147483648.0, 16777217, 65535 };
  for (const char* name : { "actor", "block", "cell" })
  {
    AddArray(image, name, VTK_INT, 1, [&](int i, int) { return ids[i % 7]; });
  }
  AddArray(image, "shadow_0", VTK_FLOAT, 1, [](int i, int) { return i % 2; });
  AddArray(image, "p", VTK_FLOAT, 1, [](int i, int) { return i == 4 ? -Infinity : Wave(i, 0); });
  AddArray(image, "U velocity", VTK_DOUBLE, 3,
    [](int i, int c) { return static_cast<double>(static_cast<float>(Wave(i, c))); });
  AddArray(image, "stress.tensor", VTK_FLOAT, 6, Wave);
  AddArray(image, "uv", VTK_FLOAT, 2, Wave);
  AddArray(image, "mask", VTK_UNSIGNED_CHAR, 1, [](int i, int) { return i % 256; });
  AddArray(image, "ids", VTK_ID_TYPE, 1, [](int i, int) { return i - 3; });

  AddField(image, "worldToCamera",
    { 0.8, 0, -0.6, 1.1, 0.1, 0.9, 0.2, -5000000.1, 0.6, 0, 0.8, -7.7, 0, 0, 0, 1 });
  AddField(image, "worldToNDC",
    { 1.3, 0.1, -0.2, 3, 0, 1.7, 0.4, -2, 0.3, 0.2, -1.1, 5, 0.1, 0.2, -1, 9 });
  AddField(image, "near", { 0.1 });
  AddField(image, "far", { 1234.5678901 });
  AddField(image, "relievo:origin", { origin[0], origin[1], origin[2] });
  AddStrings(image, "lights", { "{\"kind\":\"sun\"}", "{\"kind\":\"spot\"}", "" });
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Read(const std::string& file)
{
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
bool Write(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
}

//------------------------------------------------------------------------------
std::string Difference(vtkDataArray* expected, vtkDataArray* actual)
{
  if (!expected || !actual)
  {
    return expected == actual ? "" : "one of the arrays is missing";
  }
  const std::string name = expected->GetName();
  if (name != actual->GetName() || expected->GetDataType() != actual->GetDataType() ||
    expected->GetNumberOfComponents() != actual->GetNumberOfComponents() ||
    expected->GetNumberOfTuples() != actual->GetNumberOfTuples())
  {
    return "expected " + name + ", " + expected->GetDataTypeAsString() + " x " +
      std::to_string(expected->GetNumberOfComponents()) + ", got " + actual->GetName() + ", " +
      actual->GetDataTypeAsString() + " x " + std::to_string(actual->GetNumberOfComponents());
  }
  const std::size_t size = expected->GetDataTypeSize();
  const char* a = static_cast<const char*>(expected->GetVoidPointer(0));
  const char* b = static_cast<const char*>(actual->GetVoidPointer(0));
  for (vtkIdType i = 0; i < expected->GetNumberOfValues(); ++i)
  {
    if (std::memcmp(a + i * size, b + i * size, size) != 0)
    {
      const int n = expected->GetNumberOfComponents();
      return name + " differs in tuple " + std::to_string(i / n) + ", component " +
        std::to_string(i % n) + ": expected " +
        std::to_string(expected->GetComponent(i / n, static_cast<int>(i % n))) + ", got " +
        std::to_string(actual->GetComponent(i / n, static_cast<int>(i % n)));
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::string Difference(vtkImageData* expected, vtkImageData* actual)
{
  int a[3];
  int b[3];
  expected->GetDimensions(a);
  actual->GetDimensions(b);
  const int arrays = expected->GetPointData()->GetNumberOfArrays();
  if (!std::equal(a, a + 3, b) || arrays != actual->GetPointData()->GetNumberOfArrays())
  {
    return "the images have " + std::to_string(a[0]) + " x " + std::to_string(a[1]) + " and " +
      std::to_string(b[0]) + " x " + std::to_string(b[1]) + " points, " + std::to_string(arrays) +
      " and " + std::to_string(actual->GetPointData()->GetNumberOfArrays()) + " arrays";
  }
  std::string difference;
  for (int i = 0; i < arrays && difference.empty(); ++i)
  {
    difference =
      Difference(expected->GetPointData()->GetArray(i), actual->GetPointData()->GetArray(i));
  }
  return difference;
}

//------------------------------------------------------------------------------
std::string Bytes(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

//------------------------------------------------------------------------------
void WriteBytes(const std::string& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary).write(bytes.data(), bytes.size());
}

//------------------------------------------------------------------------------
std::string Listing(const std::string& folder)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    names.insert(entry.path().filename().string());
  }
  std::string listing;
  for (const std::string& name : names)
  {
    listing += (listing.empty() ? "" : " ") + name;
  }
  return listing;
}
}
