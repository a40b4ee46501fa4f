// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRAttributes.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkRelievoEXRCamera.h"
#include "vtkRelievoEXRChannels.h"
#include "vtkRelievoEXRFields.h"
#include "vtkStringArray.h"

#include <OpenEXR/ImfBoxAttribute.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfEnvmapAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace relievo::exr
{
namespace
{
const std::string Prefix = "relievo:";
const std::string LightPrefix = "relievo:light_";
constexpr std::size_t MostInList = 4096; // rays of a scanner

// Attributes used by the format itself, and those written from the arrays.
const std::set<std::string> Structural = { "channels", "chunkCount", "compression", "dataWindow",
  "displayWindow", "dwaCompressionLevel", "lineOrder", "name", "preview", "tiles", "type",
  "version", ArraysAttribute };

// Attributes for field data with a defined meaning.
const std::set<std::string> Known = { "worldToCamera", "worldToNDC", "near", "far",
  "relievo:origin", "relievo:worldToCamera", "relievo:worldToNDC", "relievo:near", "relievo:far",
  "lights", "chromaticities", "envmap" };

bool IsReserved(const std::string& name)
{
  return Structural.count(name) > 0 || Known.count(name) > 0 || name.rfind(Prefix, 0) == 0;
}

void WriteStrings(vtkStringArray* strings, const std::string& name, Imf::Header& header)
{
  Imf::StringVector values;
  for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
  {
    values.push_back(strings->GetValue(i));
  }
  if (name == "lights")
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      Insert(header, LightPrefix + std::to_string(i), Imf::StringAttribute(values[i]));
    }
  }
  else if (values.size() == 1)
  {
    Insert(header, name, Imf::StringAttribute(values[0]));
  }
  else if (!values.empty())
  {
    Insert(header, name, Imf::StringVectorAttribute(values));
  }
}

// Writes numbers as vector or matrix attributes of one scalar type.
template <typename T>
void WriteVector(const std::vector<double>& v, const std::string& name, Imf::Header& header)
{
  T t[16] = {};
  std::transform(v.begin(), v.begin() + std::min<std::size_t>(16, v.size()), t,
    [](double value) { return static_cast<T>(value); });
  if (v.size() == 1)
  {
    Insert(header, name, Imf::TypedAttribute<T>(t[0]));
  }
  else if (v.size() == 2)
  {
    Insert(header, name, Imf::TypedAttribute<Imath::Vec2<T>>({ t[0], t[1] }));
  }
  else if (v.size() == 3)
  {
    Insert(header, name, Imf::TypedAttribute<Imath::Vec3<T>>({ t[0], t[1], t[2] }));
  }
  else if constexpr (std::is_floating_point<T>::value)
  {
    if (v.size() == 9)
    {
      Imath::Matrix33<T> m;
      std::copy(t, t + 9, m[0]);
      Insert(header, name, Imf::TypedAttribute<Imath::Matrix33<T>>(m));
    }
    else if (v.size() == 16)
    {
      Imath::Matrix44<T> m;
      std::copy(t, t + 16, m[0]);
      Insert(header, name, Imf::TypedAttribute<Imath::Matrix44<T>>(m));
    }
  }
}

// Writes numbers of doubles that fit no vector or matrix as text: [1, 2.5, ...].
std::string WriteList(const std::vector<double>& values)
{
  std::string text;
  for (const double value : values)
  {
    char digits[32];
    text += (text.empty() ? "[" : ", ") +
      std::string(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
  }
  return text + "]";
}

// Empty if the text is not such a list.
std::vector<double> ReadList(const std::string& text)
{
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (bool first = true; at != end && *at == (first ? '[' : ','); first = false)
  {
    at += first || end - at < 2 || at[1] != ' ' ? 1 : 2;
    double value = 0.0;
    const std::from_chars_result read = std::from_chars(at, end, value);
    if (read.ec != std::errc())
    {
      return {};
    }
    values.push_back(value);
    at = read.ptr;
  }
  return end - at == 1 && *at == ']' ? values : std::vector<double>();
}

void WriteNumbers(vtkDataArray* array, const std::string& name, Imf::Header& header)
{
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  const bool isList = array->GetDataType() == VTK_DOUBLE && count > 3 && count != 9 && count != 16;
  if (count > (isList ? MostInList : 16))
  {
    return;
  }
  std::vector<double> v;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    const int components = array->GetNumberOfComponents();
    v.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
  }
  if (name == "chromaticities")
  {
    if (v.size() == 8)
    {
      const std::vector<float> f(v.begin(), v.end());
      Insert(header, name,
        Imf::ChromaticitiesAttribute(
          { { f[0], f[1] }, { f[2], f[3] }, { f[4], f[5] }, { f[6], f[7] } }));
    }
  }
  else if (name == "envmap")
  {
    if (v.size() == 1 && (v[0] == Imf::ENVMAP_LATLONG || v[0] == Imf::ENVMAP_CUBE))
    {
      Insert(header, name, Imf::EnvmapAttribute(static_cast<Imf::Envmap>(v[0])));
    }
  }
  else if (isList)
  {
    Insert(header, name, Imf::StringAttribute(WriteList(v)));
  }
  else if (array->GetDataType() == VTK_FLOAT)
  {
    WriteVector<float>(v, name, header);
  }
  else if (array->GetDataType() == VTK_DOUBLE)
  {
    WriteVector<double>(v, name, header);
  }
  else if (array->GetDataType() == VTK_INT)
  {
    WriteVector<int>(v, name, header);
  }
}

void AddStrings(vtkFieldData* fields, const std::string& name, const Imf::StringVector& values)
{
  vtkNew<vtkStringArray> strings;
  strings->SetName(name.c_str());
  for (const std::string& value : values)
  {
    strings->InsertNextValue(value);
  }
  fields->AddArray(strings);
}

void ReadLights(const Imf::Header& header, vtkFieldData* fields)
{
  Imf::StringVector lights;
  while (const std::string* light =
           ValueOf<std::string>(header, LightPrefix + std::to_string(lights.size())))
  {
    lights.push_back(*light);
  }
  if (!lights.empty())
  {
    AddStrings(fields, "lights", lights);
  }
}

// Adds an attribute of one or several T; returns false for other types.
template <typename T>
bool ReadVector(
  const Imf::Header& header, const std::string& name, int vtkType, vtkFieldData* fields)
{
  std::vector<double> v;
  if (const T* one = ValueOf<T>(header, name))
  {
    v = { static_cast<double>(*one) };
  }
  else if (const auto* two = ValueOf<Imath::Vec2<T>>(header, name))
  {
    v.assign(two->getValue(), two->getValue() + 2);
  }
  else if (const auto* three = ValueOf<Imath::Vec3<T>>(header, name))
  {
    v.assign(three->getValue(), three->getValue() + 3);
  }
  else if constexpr (std::is_floating_point<T>::value)
  {
    if (const auto* m33 = ValueOf<Imath::Matrix33<T>>(header, name))
    {
      v.assign((*m33)[0], (*m33)[0] + 9);
    }
    else if (const auto* m44 = ValueOf<Imath::Matrix44<T>>(header, name))
    {
      v.assign((*m44)[0], (*m44)[0] + 16);
    }
  }
  if (!v.empty())
  {
    AddFieldNumbers(fields, name, vtkType, v);
  }
  return !v.empty();
}

void ReadOther(const Imf::Header& header, const std::string& name, vtkFieldData* fields)
{
  if (ReadVector<int>(header, name, VTK_INT, fields) ||
    ReadVector<float>(header, name, VTK_FLOAT, fields) ||
    ReadVector<double>(header, name, VTK_DOUBLE, fields))
  {
    return;
  }
  if (const std::string* text = ValueOf<std::string>(header, name))
  {
    const std::vector<double> list = ReadList(*text);
    if (list.empty())
    {
      AddStrings(fields, name, { *text });
    }
    else
    {
      AddFieldNumbers(fields, name, VTK_DOUBLE, list);
    }
  }
  else if (const Imf::StringVector* texts = ValueOf<Imf::StringVector>(header, name))
  {
    AddStrings(fields, name, *texts);
  }
  else if (const Imf::Envmap* envmap = ValueOf<Imf::Envmap>(header, name))
  {
    AddFieldNumbers(fields, name, VTK_INT, { static_cast<double>(*envmap) });
  }
  else if (const auto* c = ValueOf<Imf::Chromaticities>(header, name))
  {
    AddFieldNumbers(fields, name, VTK_FLOAT,
      { c->red.x, c->red.y, c->green.x, c->green.y, c->blue.x, c->blue.y, c->white.x, c->white.y });
  }
}
}

//------------------------------------------------------------------------------
bool IsFreeAttribute(const std::string& name)
{
  // Every header has these three, with a fixed type.
  const bool standard =
    name == "pixelAspectRatio" || name == "screenWindowCenter" || name == "screenWindowWidth";
  return !name.empty() && name.size() <= LongestName && !IsReserved(name) && !standard;
}

//------------------------------------------------------------------------------
void WriteAttributes(vtkFieldData* fields, const std::set<std::string>& except, Imf::Header& header)
{
  WriteCamera(fields, header);
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const bool own = name == "lights" || name == "chromaticities" || name == "envmap";
    const bool skip = (IsReserved(name) && !own) || except.count(name) > 0;
    if (name.empty() || name.size() > LongestName || skip)
    {
      continue;
    }
    if (vtkStringArray* strings = vtkStringArray::SafeDownCast(array))
    {
      WriteStrings(strings, name, header);
    }
    else if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(array))
    {
      WriteNumbers(numbers, name, header);
    }
  }
}

//------------------------------------------------------------------------------
void ReadAttributes(const Imf::Header& header, vtkFieldData* fields)
{
  ReadCamera(header, fields);
  ReadLights(header, fields);
  for (const char* name : { "displayWindow", "dataWindow" })
  {
    const Imath::Box2i* box = ValueOf<Imath::Box2i>(header, name);
    AddFieldNumbers(fields, name, VTK_INT,
      { double(box->min.x), double(box->min.y), double(box->max.x), double(box->max.y) });
  }
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
  {
    const std::string name = attribute.name();
    const bool own = name == "chromaticities" || name == "envmap";
    // A foreign attribute "lights" would replace ours.
    if (!IsReserved(name) || own)
    {
      ReadOther(header, name, fields);
    }
  }
}
}
