// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDataBytes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace relievo
{
namespace
{
// No user has deeper composites.
constexpr int DeepestBlock = 200;

constexpr double MostPoints = 1e18; // of an image: VTK's numbers of points must not overflow

constexpr std::uint64_t MostOfNone = 1 << 16; // components of an array without tuples

enum class Kind : unsigned char
{
  None,
  Mesh,
  Image,
  Blocks,
  Pieces
};

// Types of arrays.
constexpr int Types[] = { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE, VTK_STRING };

std::uint64_t CountBytes(vtkAbstractArray* array)
{
  const auto values = static_cast<std::uint64_t>(array->GetNumberOfValues());
  return array->GetDataType() == VTK_BIT
    ? (values + 7) / 8
    : values * static_cast<std::uint64_t>(array->GetDataTypeSize());
}

// An array with its values in contiguous memory.
vtkSmartPointer<vtkDataArray> GetPlain(vtkDataArray* array)
{
  if (array->HasStandardMemoryLayout() || array->GetDataType() == VTK_BIT)
  {
    return array;
  }
  auto plain =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  plain->DeepCopy(array);
  return plain;
}

//------------------------------------------------------------------------------
void PutName(ByteWriter& writer, const char* name)
{
  writer(name != nullptr, std::string(name ? name : ""));
}

void PutTable(ByteWriter& writer, vtkLookupTable* table)
{
  writer(table != nullptr);
  if (!table)
  {
    return;
  }
  vtkUnsignedCharArray* colors = table->GetTable();
  const std::size_t size = static_cast<std::size_t>(colors->GetNumberOfValues());
  writer(std::vector<unsigned char>(colors->GetPointer(0), colors->GetPointer(0) + size),
    table->GetTableRange()[0], table->GetTableRange()[1]);
}

// Writes none for arrays of neither numbers nor strings.
void PutArray(ByteWriter& writer, vtkAbstractArray* array)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  auto* strings = vtkStringArray::SafeDownCast(array);
  writer(numbers != nullptr || strings != nullptr);
  if (!numbers && !strings)
  {
    return;
  }
  const std::int64_t known = writer.FindNumber(array);
  writer(known);
  if (known >= 0)
  {
    return;
  }
  const int components = array->GetNumberOfComponents();
  writer(array->GetDataType(), components, static_cast<std::int64_t>(array->GetNumberOfTuples()));
  PutName(writer, array->GetName());
  writer(array->HasAComponentName());
  for (int i = 0; i < components && array->HasAComponentName(); ++i)
  {
    PutName(writer, array->GetComponentName(i));
  }
  if (strings)
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      writer(std::string(strings->GetValue(i)));
    }
    return;
  }
  PutTable(writer, numbers->GetLookupTable());
  const vtkSmartPointer<vtkDataArray> plain = GetPlain(numbers);
  const std::uint64_t bytes = CountBytes(plain);
  writer.PutBytes(bytes > 0 ? plain->GetVoidPointer(0) : nullptr, bytes);
}

void PutField(ByteWriter& writer, vtkFieldData* field)
{
  const int count = field ? field->GetNumberOfArrays() : 0;
  writer(count);
  for (int i = 0; i < count; ++i)
  {
    PutArray(writer, field->GetAbstractArray(i));
  }
}

// Arrays that were left out get no number when read, so attributes are written by kind and with the
// array itself.
void PutAttributes(ByteWriter& writer, vtkDataSetAttributes* attributes)
{
  PutField(writer, attributes);
  for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
  {
    PutArray(writer, attributes->GetAbstractAttribute(kind));
  }
}

template <typename Integers>
void PutIntegers(ByteWriter& writer, vtkDataArray* array)
{
  vtkNew<Integers> plain;
  Integers* written = Integers::SafeDownCast(array);
  if (!written)
  {
    plain->DeepCopy(array);
    written = plain;
  }
  const auto size = static_cast<std::uint64_t>(written->GetNumberOfValues());
  writer(size);
  writer.PutBytes(
    written->GetPointer(0), size * static_cast<std::uint64_t>(written->GetDataTypeSize()));
}

void PutCells(ByteWriter& writer, vtkCellArray* cells)
{
  const bool there = cells && cells->GetNumberOfCells() > 0;
  writer(there);
  if (!there)
  {
    return;
  }
  const bool large = cells->IsStorage64Bit();
  writer(large);
  for (vtkDataArray* array : { cells->GetOffsetsArray(), cells->GetConnectivityArray() })
  {
    large ? PutIntegers<vtkTypeInt64Array>(writer, array)
          : PutIntegers<vtkTypeInt32Array>(writer, array);
  }
}

void PutMesh(ByteWriter& writer, vtkPolyData* mesh)
{
  vtkPoints* points = mesh->GetPoints();
  PutArray(writer, points ? points->GetData() : nullptr);
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    PutCells(writer, cells);
  }
  PutAttributes(writer, mesh->GetPointData());
  PutAttributes(writer, mesh->GetCellData());
  PutField(writer, mesh->GetFieldData());
}

void PutImage(ByteWriter& writer, vtkImageData* image)
{
  for (int i = 0; i < 6; ++i)
  {
    writer(image->GetExtent()[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    writer(image->GetOrigin()[i], image->GetSpacing()[i]);
  }
  const double* direction = image->GetDirectionMatrix()->GetData();
  for (int i = 0; i < 9; ++i)
  {
    writer(direction[i]);
  }
  PutAttributes(writer, image->GetPointData());
  PutAttributes(writer, image->GetCellData());
  PutField(writer, image->GetFieldData());
}

// Writes a piece of several, or a block.
void PutPart(ByteWriter& writer, bool hasData, vtkInformation* about, vtkDataObject* part)
{
  PutName(writer,
    hasData && about->Has(vtkCompositeDataSet::NAME()) ? about->Get(vtkCompositeDataSet::NAME())
                                                       : nullptr);
  PutData(writer, part);
}

//------------------------------------------------------------------------------
bool GetName(ByteReader& reader, std::string& name)
{
  const bool there = reader.Get<bool>();
  reader(name);
  return there;
}

template <typename Object>
Object* FindObject(ByteReader& reader, std::int64_t number)
{
  auto& all = reader.Objects;
  if (number < 0 || number >= static_cast<std::int64_t>(all.size()))
  {
    ByteReader::Refuse();
  }
  Object* found = Object::SafeDownCast(all[static_cast<std::size_t>(number)]);
  if (!found)
  {
    ByteReader::Refuse();
  }
  return found;
}

vtkSmartPointer<vtkLookupTable> GetTable(ByteReader& reader)
{
  if (!reader.Get<bool>())
  {
    return nullptr;
  }
  const auto colors = reader.Get<std::vector<unsigned char>>();
  double range[2];
  reader(range[0], range[1]);
  if (!(range[0] <= range[1]))
  {
    ByteReader::Refuse();
  }
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(colors.size() / 4));
  std::copy_n(colors.begin(), colors.size() / 4 * 4, table->GetTable()->GetPointer(0));
  table->SetTableRange(range);
  return table;
}

vtkSmartPointer<vtkAbstractArray> GetArray(ByteReader& reader)
{
  if (!reader.Get<bool>())
  {
    return nullptr;
  }
  const auto known = reader.Get<std::int64_t>();
  if (known >= 0)
  {
    return FindObject<vtkAbstractArray>(reader, known);
  }
  const auto type = reader.Get<int>();
  const auto components = reader.Get<int>();
  const auto tuples = reader.Get<std::int64_t>();
  if (std::find(std::begin(Types), std::end(Types), type) == std::end(Types))
  {
    ByteReader::Refuse();
  }
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  auto* numbers = vtkDataArray::SafeDownCast(array);
  auto* strings = vtkStringArray::SafeDownCast(array);
  // VTK also allocates memory per component.
  const std::uint64_t left = 8 * static_cast<std::uint64_t>(reader.GetLeft()); // bits
  const auto mostComponents = tuples > 0 ? left / static_cast<std::uint64_t>(tuples) : MostOfNone;
  if ((!numbers && !strings) || tuples < 0 || components < 1 ||
    static_cast<std::uint64_t>(components) > mostComponents)
  {
    ByteReader::Refuse();
  }
  reader.Objects.push_back(array.Get());
  array->SetNumberOfComponents(components);
  std::string name;
  if (GetName(reader, name))
  {
    array->SetName(name.c_str());
  }
  const bool named = reader.Get<bool>();
  for (int i = 0; i < components && named; ++i)
  {
    if (GetName(reader, name))
    {
      array->SetComponentName(i, name.c_str());
    }
  }
  if (strings)
  {
    for (std::int64_t i = 0; i < tuples * components; ++i)
    {
      strings->InsertNextValue(reader.Get<std::string>());
    }
    return array;
  }
  numbers->SetLookupTable(GetTable(reader));
  // Allocates only as much memory as there are bytes.
  const bool bits = type == VTK_BIT;
  const auto values = static_cast<std::uint64_t>(tuples) * static_cast<std::uint64_t>(components);
  const auto each = static_cast<std::uint64_t>(array->GetDataTypeSize());
  if (!bits && values > UINT64_MAX / each)
  {
    ByteReader::Refuse();
  }
  const std::uint64_t size = bits ? (values + 7) / 8 : values * each;
  const char* bytes = reader.Take(size);
  array->SetNumberOfTuples(tuples);
  if (size > 0)
  {
    std::memcpy(array->GetVoidPointer(0), bytes, size);
  }
  return array;
}

// Reads arrays of at least `least` tuples.
void GetField(ByteReader& reader, vtkFieldData* field, vtkIdType least = 0)
{
  for (int count = reader.Get<int>(); count > 0; --count)
  {
    if (const vtkSmartPointer<vtkAbstractArray> array = GetArray(reader))
    {
      if (array->GetNumberOfTuples() < least)
      {
        ByteReader::Refuse();
      }
      field->AddArray(array);
    }
  }
}

void GetAttributes(ByteReader& reader, vtkDataSetAttributes* attributes, vtkIdType least)
{
  GetField(reader, attributes, least);
  for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
  {
    if (const vtkSmartPointer<vtkAbstractArray> array = GetArray(reader))
    {
      if (array->GetNumberOfTuples() < least)
      {
        ByteReader::Refuse();
      }
      attributes->SetAttribute(array, kind);
    }
  }
}

template <typename Integers>
vtkSmartPointer<Integers> GetIntegers(ByteReader& reader)
{
  auto array = vtkSmartPointer<Integers>::New();
  const std::size_t each = static_cast<std::size_t>(array->GetDataTypeSize());
  const std::size_t count = reader.GetCount(each);
  const char* bytes = reader.Take(count * each);
  array->SetNumberOfValues(static_cast<vtkIdType>(count));
  std::copy_n(bytes, count * each, reinterpret_cast<char*>(array->GetPointer(0)));
  return array;
}

vtkSmartPointer<vtkCellArray> GetCells(ByteReader& reader, vtkIdType points)
{
  if (!reader.Get<bool>())
  {
    return nullptr;
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto take = [&](auto kind) {
    using Integers = std::remove_pointer_t<decltype(kind)>;
    const vtkSmartPointer<Integers> offsets = GetIntegers<Integers>(reader);
    const vtkSmartPointer<Integers> connectivity = GetIntegers<Integers>(reader);
    const auto* begin = connectivity->GetPointer(0);
    const bool fits = std::all_of(begin, begin + connectivity->GetNumberOfValues(),
      [points](auto point) { return point >= 0 && point < points; });
    if (!fits || offsets->GetNumberOfValues() == 0)
    {
      ByteReader::Refuse();
    }
    cells->SetData(offsets.Get(), connectivity.Get());
  };
  reader.Get<bool>() ? take(static_cast<vtkTypeInt64Array*>(nullptr))
                     : take(static_cast<vtkTypeInt32Array*>(nullptr));
  if (!cells->IsValid())
  {
    ByteReader::Refuse();
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> GetMesh(ByteReader& reader)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  if (const vtkSmartPointer<vtkAbstractArray> places = GetArray(reader))
  {
    auto* numbers = vtkDataArray::SafeDownCast(places);
    if (!numbers || numbers->GetNumberOfComponents() != 3)
    {
      ByteReader::Refuse();
    }
    vtkNew<vtkPoints> points;
    points->SetData(numbers);
    mesh->SetPoints(points);
  }
  using Set = void (vtkPolyData::*)(vtkCellArray*);
  for (const Set set :
    { static_cast<Set>(&vtkPolyData::SetVerts), static_cast<Set>(&vtkPolyData::SetLines),
      static_cast<Set>(&vtkPolyData::SetPolys), static_cast<Set>(&vtkPolyData::SetStrips) })
  {
    if (const vtkSmartPointer<vtkCellArray> cells = GetCells(reader, mesh->GetNumberOfPoints()))
    {
      (mesh.Get()->*set)(cells);
    }
  }
  GetAttributes(reader, mesh->GetPointData(), mesh->GetNumberOfPoints());
  GetAttributes(reader, mesh->GetCellData(), mesh->GetNumberOfCells());
  GetField(reader, mesh->GetFieldData());
  return mesh;
}

vtkSmartPointer<vtkImageData> GetImage(ByteReader& reader)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  for (int& end : extent)
  {
    reader(end);
  }
  double points = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t side = std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1;
    points *= static_cast<double>(side);
    if (side < 0 || side > INT_MAX || points > MostPoints)
    {
      ByteReader::Refuse();
    }
  }
  image->SetExtent(extent);
  double origin[3], spacing[3];
  for (int i = 0; i < 3; ++i)
  {
    reader(origin[i], spacing[i]);
  }
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  double direction[9];
  for (double& element : direction)
  {
    reader(element);
  }
  image->SetDirectionMatrix(direction);
  GetAttributes(reader, image->GetPointData(), image->GetNumberOfPoints());
  GetAttributes(reader, image->GetCellData(), image->GetNumberOfCells());
  GetField(reader, image->GetFieldData());
  return image;
}

vtkSmartPointer<vtkDataObject> GetDeep(ByteReader& reader, int depth)
{
  if (depth > DeepestBlock)
  {
    ByteReader::Refuse();
  }
  const auto kind = reader.Get<Kind>();
  const auto forParts = [&](const auto& take) {
    const std::size_t count = reader.GetCount(1);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::string name;
      const bool named = GetName(reader, name);
      take(static_cast<unsigned int>(i), GetDeep(reader, depth + 1), named ? &name : nullptr);
    }
  };
  const auto keepName = [](vtkInformation* about, const std::string* name) {
    if (name)
    {
      about->Set(vtkCompositeDataSet::NAME(), *name);
    }
  };
  switch (kind)
  {
    case Kind::Mesh:
      return GetMesh(reader);
    case Kind::Image:
      return GetImage(reader);
    case Kind::Blocks:
    {
      auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      forParts([&](unsigned int i, vtkDataObject* part, const std::string* name) {
        blocks->SetBlock(i, part);
        if (name)
        {
          keepName(blocks->GetMetaData(i), name);
        }
      });
      return blocks;
    }
    case Kind::Pieces:
    {
      auto pieces = vtkSmartPointer<vtkMultiPieceDataSet>::New();
      forParts([&](unsigned int i, vtkDataObject* part, const std::string* name) {
        pieces->SetPiece(i, part);
        if (name)
        {
          keepName(pieces->GetMetaData(i), name);
        }
      });
      return pieces;
    }
    default:
      return nullptr;
  }
}
}

//------------------------------------------------------------------------------
void PutData(ByteWriter& writer, vtkDataObject* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    writer(Kind::Mesh);
    PutMesh(writer, mesh);
  }
  else if (auto* image = vtkImageData::SafeDownCast(data))
  {
    writer(Kind::Image);
    PutImage(writer, image);
  }
  else if (auto* pieces = vtkMultiPieceDataSet::SafeDownCast(data))
  {
    writer(Kind::Pieces, static_cast<std::uint64_t>(pieces->GetNumberOfPieces()));
    for (unsigned int i = 0; i < pieces->GetNumberOfPieces(); ++i)
    {
      const bool named = pieces->HasMetaData(i) != 0;
      PutPart(
        writer, named, named ? pieces->GetMetaData(i) : nullptr, pieces->GetPieceAsDataObject(i));
    }
  }
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    writer(Kind::Blocks, static_cast<std::uint64_t>(blocks->GetNumberOfBlocks()));
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      const bool named = blocks->HasMetaData(i) != 0;
      PutPart(writer, named, named ? blocks->GetMetaData(i) : nullptr, blocks->GetBlock(i));
    }
  }
  else if (auto* other = vtkCompositeDataSet::SafeDownCast(data))
  {
    // Other composites become a list of their leaves.
    vtkNew<vtkMultiBlockDataSet> list;
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(other->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      list->SetBlock(list->GetNumberOfBlocks(), each->GetCurrentDataObject());
    }
    PutData(writer, list);
  }
  else
  {
    writer(Kind::None);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> GetData(ByteReader& reader)
{
  return GetDeep(reader, 0);
}
}
