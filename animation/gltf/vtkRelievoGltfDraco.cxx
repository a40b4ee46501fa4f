// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfParts.h"

#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>

#include <memory>

namespace relievo
{
namespace
{
// Reads the attribute's values, one per point; integers stay as they are.
bool ReadValues(const draco::PointAttribute& attribute, std::size_t count, GltfNumbers& numbers)
{
  numbers.Count = count;
  numbers.Components = static_cast<std::size_t>(attribute.num_components());
  numbers.Values.resize(count * numbers.Components);
  const bool isReal = attribute.data_type() == draco::DT_FLOAT32;
  std::vector<float> reals(numbers.Components);
  std::vector<std::int64_t> wholes(numbers.Components);
  for (std::size_t i = 0; i < count; ++i)
  {
    const draco::AttributeValueIndex at =
      attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (at.value() >= attribute.size() ||
      !(isReal ? attribute.ConvertValue(at, attribute.num_components(), reals.data())
               : attribute.ConvertValue(at, attribute.num_components(), wholes.data())))
    {
      return false;
    }
    for (std::size_t j = 0; j < numbers.Components; ++j)
    {
      numbers.Values[i * numbers.Components + j] =
        isReal ? reals[j] : static_cast<double>(wholes[j]);
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
void ReadGltfDraco(GltfDocument& document, const GltfValue& primitive, GltfPrimitive& result)
{
  const GltfValue value = primitive.Get("extensions").Get("KHR_draco_mesh_compression");
  const int view =
    value.Get("bufferView").GetIndex("bufferViews", document.Get("bufferViews").GetSize());
  if (view < 0)
  {
    value.Get("bufferView").FailExpecting("a number");
  }
  const GltfBytes bytes = document.GetView(static_cast<std::size_t>(view));
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.Data), bytes.Size);
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
  {
    value.Fail(std::string("cannot be decoded: ") + decoded.status().error_msg());
  }
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  const auto count = static_cast<std::size_t>(mesh->num_points());
  const std::size_t corners = 3 * static_cast<std::size_t>(mesh->num_faces());
  result.IsIndexed = true;
  result.Indices.reserve(corners);
  for (std::uint32_t i = 0; i < mesh->num_faces(); ++i)
  {
    for (const draco::PointIndex& point : mesh->face(draco::FaceIndex(i)))
    {
      result.Indices.push_back(point.value());
    }
  }
  const GltfValue accessors = primitive.Get("attributes");
  const GltfValue ids = value.Get("attributes");
  for (const std::string& name : ids.GetKeys())
  {
    const GltfValue id = ids.Get(name.c_str());
    const draco::PointAttribute* attribute =
      mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id.GetCount(0)));
    const GltfValue place = accessors.Get(name.c_str());
    if (!attribute)
    {
      id.Fail("names an attribute that the compressed mesh has not");
    }
    GltfNumbers numbers;
    if (!ReadValues(*attribute, count, numbers))
    {
      id.Fail("names an attribute whose values are not those of its points");
    }
    document.CheckDecoded(place, numbers);
    result.Attributes.emplace(name, std::move(numbers));
  }
}
}
