// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data objects as bytes and back: every kind of array and cell, bit for bit, and bytes that are
// none.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkLookupTable.h>
#include <vtkMatrix3x3.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiPieceDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoDataBytes.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace testDataBytes
{
namespace
{
using relievo::ByteReader;
using relievo::ByteWriter;

std::vector<char> ToBytes(vtkDataObject* data)
{
  std::vector<char> bytes;
  ByteWriter writer(
    [&bytes](const char* part, std::size_t size) { bytes.insert(bytes.end(), part, part + size); });
  relievo::PutData(writer, data);
  writer.Flush();
  return bytes;
}

vtkSmartPointer<vtkDataObject> FromBytes(const std::vector<char>& bytes)
{
  ByteReader reader(bytes.data(), bytes.size());
  return relievo::GetData(reader);
}

template <typename Object>
vtkSmartPointer<Object> Copy(Object* data)
{
  return Object::SafeDownCast(FromBytes(ToBytes(data)));
}

//------------------------------------------------------------------------------
std::string Text(const char* text)
{
  return text ? text : "(none)";
}

// By VTK's own interface.
bool AreSame(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b)
  {
    return a == b;
  }
  bool same = a->GetDataType() == b->GetDataType() && Text(a->GetName()) == Text(b->GetName()) &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples();
  for (int i = 0; same && i < a->GetNumberOfComponents(); ++i)
  {
    same = Text(a->GetComponentName(i)) == Text(b->GetComponentName(i));
  }
  if (auto* strings = vtkStringArray::SafeDownCast(a))
  {
    for (vtkIdType i = 0; same && i < strings->GetNumberOfValues(); ++i)
    {
      same = strings->GetValue(i) == vtkStringArray::SafeDownCast(b)->GetValue(i);
    }
    return same;
  }
  // NaN has a payload, which no comparison of numbers sees.
  const std::size_t bytes = a->GetDataType() == VTK_BIT
    ? static_cast<std::size_t>(a->GetNumberOfValues() / 8)
    : static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize());
  return same &&
    (bytes == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0);
}

bool AreSame(vtkFieldData* a, vtkFieldData* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    same = AreSame(a->GetAbstractArray(i), b->GetAbstractArray(i));
  }
  return same;
}

bool AreSameAttributes(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  bool same = AreSame(static_cast<vtkFieldData*>(a), b);
  for (int i = 0; same && i < vtkDataSetAttributes::NUM_ATTRIBUTES; ++i)
  {
    vtkAbstractArray* one = a->GetAbstractAttribute(i);
    vtkAbstractArray* other = b->GetAbstractAttribute(i);
    same = (one != nullptr) == (other != nullptr) &&
      (!one || Text(one->GetName()) == Text(other->GetName()));
  }
  return same;
}

bool AreSame(vtkCellArray* a, vtkCellArray* b)
{
  return a->GetNumberOfCells() == b->GetNumberOfCells() &&
    (a->GetNumberOfCells() == 0 ||
      (a->IsStorage64Bit() == b->IsStorage64Bit() &&
        AreSame(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
        AreSame(a->GetConnectivityArray(), b->GetConnectivityArray())));
}

bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  return a && b && (a->GetPoints() != nullptr) == (b->GetPoints() != nullptr) &&
    (!a->GetPoints() || AreSame(a->GetPoints()->GetData(), b->GetPoints()->GetData())) &&
    AreSame(a->GetVerts(), b->GetVerts()) && AreSame(a->GetLines(), b->GetLines()) &&
    AreSame(a->GetPolys(), b->GetPolys()) && AreSame(a->GetStrips(), b->GetStrips()) &&
    AreSameAttributes(a->GetPointData(), b->GetPointData()) &&
    AreSameAttributes(a->GetCellData(), b->GetCellData()) &&
    AreSame(a->GetFieldData(), b->GetFieldData());
}

//------------------------------------------------------------------------------
// Any bits, among them NaN of all kinds.
void Fill(vtkDataArray* array, unsigned int seed)
{
  std::mt19937 random(seed);
  auto* bytes = static_cast<unsigned char*>(array->GetVoidPointer(0));
  const vtkIdType size = array->GetDataType() == VTK_BIT
    ? (array->GetNumberOfValues() + 7) / 8
    : array->GetNumberOfValues() * array->GetDataTypeSize();
  for (vtkIdType i = 0; i < size; ++i)
  {
    bytes[i] = static_cast<unsigned char>(random());
  }
}

// Points, cells of every kind, and an array of every type.
vtkSmartPointer<vtkPolyData> MakeMesh(bool large)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(large ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(17);
  Fill(points->GetData(), 1);
  mesh->SetPoints(points);
  const std::vector<std::vector<vtkIdType>> cells[4] = { { { 0 }, { 1, 2, 3 } },
    { { 0, 1 }, { 2, 3, 4, 16 } }, { { 0, 1, 2 }, { 3, 4, 5, 6, 7 } }, { { 8, 9, 10, 11 } } };
  vtkNew<vtkCellArray> made[4];
  for (int i = 0; i < 4; ++i)
  {
    large ? made[i]->Use64BitStorage() : made[i]->Use32BitStorage();
    for (const std::vector<vtkIdType>& cell : cells[i])
    {
      made[i]->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
    }
  }
  mesh->SetVerts(made[0]);
  mesh->SetLines(made[1]);
  mesh->SetPolys(made[2]);
  mesh->SetStrips(made[3]);
  const int types[] = { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
    VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
    VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE };
  unsigned int seed = 10;
  for (const int type : types)
  {
    const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->SetName(("type " + std::to_string(type)).c_str());
    array->SetNumberOfComponents(1 + static_cast<int>(seed % 4));
    array->SetNumberOfTuples(17);
    Fill(array, ++seed);
    if (array->GetNumberOfComponents() > 1)
    {
      array->SetComponentName(1, "second, alone");
    }
    mesh->GetPointData()->AddArray(array);
  }
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  for (int i = 0; i < 7; ++i)
  {
    strings->InsertNextValue(i % 2 ? std::string("a\0b\n\xff", 5) : std::string(i * 100, 'x'));
  }
  mesh->GetCellData()->AddArray(strings);
  vtkNew<vtkFloatArray> unnamed;
  unnamed->SetNumberOfTuples(0);
  mesh->GetFieldData()->AddArray(unnamed);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfTuples(7);
  ghosts->FillValue(1);
  mesh->GetCellData()->AddArray(ghosts);
  return mesh;
}

//------------------------------------------------------------------------------
void TestMeshes()
{
  for (const bool large : { false, true })
  {
    const auto mesh = MakeMesh(large);
    RELIEVO_CHECK(AreSame(mesh.Get(), Copy(mesh.Get()).Get()));
  }
  vtkNew<vtkPolyData> nothing;
  const auto copy = Copy(nothing.Get());
  RELIEVO_CHECK(AreSame(nothing.Get(), copy.Get()) && !copy->GetPoints());
  RELIEVO_CHECK(!FromBytes(ToBytes(nullptr)));
  // The comparison is one.
  const auto other = MakeMesh(true);
  other->GetPointData()->GetArray(13)->SetComponent(3, 0, 7.);
  RELIEVO_CHECK(!AreSame(MakeMesh(true).Get(), other.Get()));
}

void TestAttributes()
{
  const auto mesh = MakeMesh(true);
  for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(vtkDataSetAttributes::GetAttributeTypeAsString(kind));
    const bool single = kind == vtkDataSetAttributes::GLOBALIDS ||
      kind == vtkDataSetAttributes::PEDIGREEIDS || kind == vtkDataSetAttributes::EDGEFLAG ||
      kind == vtkDataSetAttributes::RATIONALWEIGHTS ||
      kind > vtkDataSetAttributes::HIGHERORDERDEGREES; // of newer VTK
    array->SetNumberOfComponents(single ? 1 : kind == vtkDataSetAttributes::TENSORS ? 9 : 3);
    array->SetNumberOfTuples(17);
    mesh->GetPointData()->SetAttribute(array, kind);
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfTuples(17);
  mesh->GetPointData()->SetGlobalIds(ids);
  RELIEVO_CHECK(mesh->GetPointData()->GetScalars() && mesh->GetPointData()->GetGlobalIds());
  const auto copy = Copy(mesh.Get());
  RELIEVO_CHECK(AreSame(mesh.Get(), copy.Get()));
  RELIEVO_CHECK(
    copy->GetPointData()->GetGlobalIds() == copy->GetPointData()->GetAbstractArray("ids"));
}

// Colours of a file, values that lie apart, and one array of two data.
void TestArrays()
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkFloatArray> colored;
  colored->SetName("colored");
  colored->SetNumberOfTuples(5);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(3);
  table->SetTableRange(-1., 2.5);
  table->SetTableValue(1, 0.2, 0.4, 0.6, 0.8);
  colored->SetLookupTable(table);
  mesh->GetPointData()->SetScalars(colored);
  mesh->GetCellData()->AddArray(colored);
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->SetName("apart");
  apart->SetNumberOfComponents(2);
  apart->SetNumberOfTuples(5);
  for (vtkIdType i = 0; i < 10; ++i)
  {
    apart->SetComponent(i / 2, static_cast<int>(i % 2), 0.1 * static_cast<double>(i));
  }
  mesh->GetPointData()->AddArray(apart);
  const auto copy = Copy(mesh.Get());
  vtkDataArray* copied = copy->GetPointData()->GetScalars();
  RELIEVO_CHECK(copied && copied == copy->GetCellData()->GetArray("colored"));
  vtkLookupTable* kept = copied->GetLookupTable();
  RELIEVO_CHECK(kept && kept->GetNumberOfTableValues() == 3 && kept->GetTableRange()[1] == 2.5);
  double a[4], b[4];
  table->GetTableValue(1, a);
  kept->GetTableValue(1, b);
  RELIEVO_CHECK(std::memcmp(a, b, sizeof a) == 0);
  vtkDataArray* joined = copy->GetPointData()->GetArray("apart");
  for (vtkIdType i = 0; i < 10; ++i)
  {
    RELIEVO_CHECK(
      joined->GetComponent(i / 2, static_cast<int>(i % 2)) == 0.1 * static_cast<double>(i));
  }
}

void TestImages()
{
  vtkNew<vtkImageData> image;
  image->SetExtent(-2, 3, 0, 4, 7, 7);
  image->SetOrigin(0.1, -2., 1e300);
  image->SetSpacing(0.3, 2., 5.);
  image->SetDirectionMatrix(0., -0.6, 0.8, 1., 0., 0., 0., 0.8, 0.6);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 3);
  Fill(image->GetPointData()->GetScalars(), 5);
  const auto copy = Copy(image.Get());
  for (int i = 0; i < 6; ++i)
  {
    RELIEVO_CHECK(copy->GetExtent()[i] == image->GetExtent()[i]);
    RELIEVO_CHECK(copy->GetOrigin()[i / 2] == image->GetOrigin()[i / 2]);
    RELIEVO_CHECK(copy->GetSpacing()[i / 2] == image->GetSpacing()[i / 2]);
  }
  for (int i = 0; i < 9; ++i)
  {
    RELIEVO_CHECK(copy->GetDirectionMatrix()->GetElement(i / 3, i % 3) ==
      image->GetDirectionMatrix()->GetElement(i / 3, i % 3));
  }
  RELIEVO_CHECK(AreSameAttributes(image->GetPointData(), copy->GetPointData()));
}

void TestComposites()
{
  vtkNew<vtkMultiBlockDataSet> blocks, inner;
  vtkNew<vtkMultiPieceDataSet> pieces;
  const auto mesh = MakeMesh(false);
  blocks->SetNumberOfBlocks(4);
  blocks->SetBlock(0, mesh);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "named");
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "empty");
  blocks->SetBlock(2, inner);
  inner->SetBlock(0, pieces);
  pieces->SetNumberOfPieces(3);
  pieces->SetPiece(1, mesh);
  const auto copy = Copy(blocks.Get());
  RELIEVO_CHECK(copy->GetNumberOfBlocks() == 4 && !copy->GetBlock(1) && !copy->GetBlock(3));
  RELIEVO_CHECK(Text(copy->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME())) == "named");
  RELIEVO_CHECK(Text(copy->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME())) == "empty");
  RELIEVO_CHECK(AreSame(mesh.Get(), vtkPolyData::SafeDownCast(copy->GetBlock(0))));
  auto* within = vtkMultiBlockDataSet::SafeDownCast(copy->GetBlock(2));
  auto* parts = within ? vtkMultiPieceDataSet::SafeDownCast(within->GetBlock(0)) : nullptr;
  RELIEVO_CHECK(parts && parts->GetNumberOfPieces() == 3 && !parts->GetPieceAsDataObject(0));
  RELIEVO_CHECK(
    parts && AreSame(mesh.Get(), vtkPolyData::SafeDownCast(parts->GetPieceAsDataObject(1))));
}

// Bytes cut off and changed anywhere: refused, or read as something else.
void TestDamage()
{
  const std::vector<char> whole = ToBytes(MakeMesh(true));
  vtkObject::GlobalWarningDisplayOff(); // of attributes that are none
  int refused = 0;
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 50)
  {
    try
    {
      FromBytes({ whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size) });
      RELIEVO_CHECK_THAT(false, "cut at " + std::to_string(size));
    }
    catch (const std::runtime_error&)
    {
      ++refused;
    }
  }
  RELIEVO_CHECK(refused > 50);
  std::mt19937 random(11);
  for (int i = 0; i < 5000; ++i)
  {
    std::vector<char> changed = whole;
    for (int k = 0; k < 4; ++k)
    {
      const char values[] = { 0, 1, 127, -1, static_cast<char>(random()) };
      changed[random() % changed.size()] = values[random() % 5];
    }
    try
    {
      FromBytes(changed);
    }
    catch (const std::runtime_error&)
    {
      ++refused;
    }
  }
  RELIEVO_CHECK(refused > 500);
  vtkObject::GlobalWarningDisplayOn();
}
}

RELIEVO_TEST_CASE(testDataBytes)
{
  relievoTest::Session session;
  TestMeshes();
  TestAttributes();
  TestArrays();
  TestImages();
  TestComposites();
  TestDamage();
  return session.Result();
}
}
