// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoOFFReader reads as documented, and refuses broken files with one clear message.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoOFFReader.h>
#include <vtkUnsignedCharArray.h>

#include <fstream>
#include <iostream>
#include <random>

namespace testOFFReader
{
namespace
{
std::string Path;

vtkSmartPointer<vtkRelievoOFFReader> Reader(const std::string& text)
{
  std::ofstream(Path, std::ios::binary) << text;
  auto reader = vtkSmartPointer<vtkRelievoOFFReader>::New();
  reader->SetFileName(Path.c_str());
  return reader;
}

// Whether element `i` of an array of colours is this one.
bool HasColor(vtkDataArray* colors, vtkIdType i, int r, int g, int b, int a)
{
  double color[4] = { -1., -1., -1., -1. };
  if (colors && colors->GetNumberOfComponents() == 4 && i < colors->GetNumberOfTuples())
  {
    colors->GetTuple(i, color);
  }
  return color[0] == r && color[1] == g && color[2] == b && color[3] == a;
}

const char* const Tetrahedron = "OFF\n"
                                "# a comment\n"
                                "4 4 6\n"
                                "\n"
                                "0 0 0 # the origin\n"
                                "+1 0 0\n"
                                "1e-999 1e0 0\r\n"
                                "0 0 0.123456789012345\n"
                                "3 0 2 1\n"
                                "3 0 1 3\n"
                                "3 1 2 3\n"
                                "3 0 3 2\n";

void TestPlain()
{
  auto reader = Reader(Tetrahedron);
  reader->Update();
  vtkPolyData* output = reader->GetOutput();
  RELIEVO_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  RELIEVO_CHECK(output->GetNumberOfPoints() == 4 && output->GetNumberOfPolys() == 4);
  RELIEVO_CHECK(output->GetPoint(3)[2] == 0.123456789012345);
  RELIEVO_CHECK(output->GetPoint(1)[0] == 1. && output->GetPoint(2)[0] == 0.);
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  output->GetPolys()->GetCellAtId(2, count, ids);
  RELIEVO_CHECK(count == 3 && ids[0] == 1 && ids[1] == 2 && ids[2] == 3);
  RELIEVO_CHECK(!output->GetCellData()->GetScalars() && !output->GetPointData()->GetScalars());

  reader->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  reader->Update();
  RELIEVO_CHECK(reader->GetOutput()->GetPoint(3)[2] == static_cast<double>(0.123456789012345f));
  RELIEVO_CHECK(vtkRelievoOFFReader::CanReadFile(Path.c_str()) == 1);

  Reader("OFF 3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2")->Update();
  reader->Update();
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPolys() == 4);
  reader->Modified();
  reader->Update();
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPolys() == 1);
}

void TestArrays()
{
  auto reader = Reader("STCNOFF\n3 1 0\n"
                       "0 0 0  0 0 1  1 0 0 1  0 0\n"
                       "1 0 0  0 1 0  0 0.5 0 1  1 0\n"
                       "0 1 0  1 0 0  0 0 1 0.2  0 0.25\n"
                       "3 0 1 2\n");
  reader->Update();
  vtkPointData* data = reader->GetOutput()->GetPointData();
  RELIEVO_CHECK(data->GetNormals() && data->GetNormals()->GetComponent(1, 1) == 1.);
  RELIEVO_CHECK(data->GetTCoords() && data->GetTCoords()->GetComponent(2, 1) == 0.25);
  RELIEVO_CHECK(HasColor(data->GetArray("RGBA"), 0, 255, 0, 0, 255));
  RELIEVO_CHECK(HasColor(data->GetArray("RGBA"), 1, 0, 128, 0, 255));
  RELIEVO_CHECK(HasColor(data->GetArray("RGBA"), 2, 0, 0, 255, 51));
}

void TestFaces()
{
  // A polygon, a line, a vertex and a quad: cells come as vertices, lines, polygons.
  auto reader = Reader("OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                       "3 0 1 2 255 0 10\n"
                       "2 0 1 7\n"
                       "1 3 1 2 3 4\n"
                       "4 0 1 2 3\n");
  reader->Update();
  vtkPolyData* output = reader->GetOutput();
  RELIEVO_CHECK(output->GetNumberOfVerts() == 1 && output->GetNumberOfLines() == 1 &&
    output->GetNumberOfPolys() == 2);
  vtkDataArray* colors = output->GetCellData()->GetArray("RGBA");
  RELIEVO_CHECK(HasColor(colors, 0, 1, 2, 3, 4));
  RELIEVO_CHECK(HasColor(colors, 1, 170, 170, 170, 255));
  RELIEVO_CHECK(HasColor(colors, 2, 255, 0, 10, 255));
  RELIEVO_CHECK(HasColor(colors, 3, 170, 170, 170, 255));
}

// The file must be refused by one message that contains `words`, with the error code.
void MustRefuse(const std::string& text, const std::string& words, unsigned long code)
{
  auto reader = Reader(text);
  int count = 0;
  {
    relievoTest::ExpectMessage expect(words);
    reader->Update();
    count = expect.Count();
    for (const std::string& message : expect.Messages())
    {
      RELIEVO_CHECK_THAT(message.find(Path) != std::string::npos, "the file is not named");
    }
  }
  RELIEVO_CHECK_THAT(count == 1, "for: " + words);
  RELIEVO_CHECK_THAT(reader->GetErrorCode() == code, "error code for: " + words);
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfCells() == 0);
}

void TestRefusals()
{
  using Code = vtkErrorCode;
  MustRefuse("", "the header OFF was expected", Code::PrematureEndOfFileError);
  MustRefuse("solid stl\n", "expected the header OFF", Code::UnrecognizedFileTypeError);
  MustRefuse("4OFF\n1 0 0\n0 0 0 1\n", "expected the header", Code::UnrecognizedFileTypeError);
  MustRefuse("OFF BINARY\n", "binary OFF", Code::UnrecognizedFileTypeError);
  MustRefuse("OFF\n", "number of vertices was expected", Code::PrematureEndOfFileError);
  MustRefuse("OFF\n-1 0 0\n", "line 2: expected the number of vertices", Code::FileFormatError);
  MustRefuse("OFF\n999999999999 1 0\n0 0 0\n", "fewer than", Code::FileFormatError);
  MustRefuse("OFF\n99999999999999999999 1 0\n", "number of vertices", Code::FileFormatError);
  MustRefuse("OFF\n1 888888 0\n0 0 0\n", "number of faces", Code::FileFormatError);
  MustRefuse("OFF\n1 0 x\n0 0 0\n", "number of edges", Code::FileFormatError);
  MustRefuse(
    "OFF\n1 1 0\n0 0", "coordinate of a vertex was expected", Code::PrematureEndOfFileError);
  MustRefuse("OFF\n1 0 0\n0 zero 0\n", "line 3: expected a coordinate", Code::FileFormatError);
  MustRefuse("OFF\n1 0 0\n0 nan 0\n", "line 3: expected a coordinate", Code::FileFormatError);
  MustRefuse("OFF\n1 0 0\n0 1e999 0\n", "line 3: expected a coordinate", Code::FileFormatError);
  MustRefuse("OFF\n1 0 0\n0 -1e+999 0\n", "line 3: expected a coordinate", Code::FileFormatError);
  MustRefuse("OFF\n1 0 0\n0 1,5 0\n", "line 3: expected a coordinate", Code::FileFormatError);
  MustRefuse("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "from 0 to 0, not '1'", Code::FileFormatError);
  MustRefuse("OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "index of a vertex", Code::FileFormatError);
  MustRefuse("OFF\n1 1 0\n0 0 0\n0\n", "at least 1", Code::FileFormatError);
  MustRefuse("OFF\n1 1 0\n0 0 0\n99999999 0\n", "number of points", Code::FileFormatError);
  MustRefuse("OFF\n1 1 0\n0 0 0\n3 0 0 0 1 2\n", "a colour of 0, 1, 3", Code::FileFormatError);
  MustRefuse("NOFF\n1 1 0\n0 0 0\n1 0\n", "the header announces", Code::FileFormatError);
  MustRefuse("COFF\n1 1 0\n0 0 0 1 1\n1 0\n", "the header announces", Code::FileFormatError);

  auto reader = vtkSmartPointer<vtkRelievoOFFReader>::New();
  {
    relievoTest::ExpectMessage expect("no file name");
    reader->Update();
  }
  RELIEVO_CHECK(reader->GetErrorCode() == Code::NoFileNameError);
  reader->SetFileName("no-such-file.off");
  {
    relievoTest::ExpectMessage expect("no-such-file.off: there is no such file");
    reader->Update();
  }
  RELIEVO_CHECK(reader->GetErrorCode() == Code::FileNotFoundError);
  RELIEVO_CHECK(vtkRelievoOFFReader::CanReadFile("no-such-file.off") == 0);
  RELIEVO_CHECK(vtkRelievoOFFReader::CanReadFile(nullptr) == 0);
}

// Broken bytes anywhere: the file is read or refused, without a crash or an index out of range.
void TestMutations()
{
  std::mt19937 random(20201121);
  const std::string good = Tetrahedron;
  int refused = 0;
  const int rounds = 2000;
  for (int round = 0; round < rounds; ++round)
  {
    std::string text = good;
    const int changes = 1 + static_cast<int>(random() % 3);
    for (int change = 0; change < changes; ++change)
    {
      const size_t place = random() % text.size();
      switch (random() % 3)
      {
        case 0:
          text[place] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.erase(place, 1 + random() % 8);
          break;
        default:
          text.insert(place, text.substr(random() % text.size(), random() % 8));
      }
      if (text.empty())
      {
        text = "OFF";
      }
    }
    auto reader = Reader(text);
    const int failures = relievoTest::FailuresOf([&] { reader->Update(); });
    const int wanted = reader->GetErrorCode() == vtkErrorCode::NoError ? 0 : 1;
    refused += wanted;
    RELIEVO_CHECK(failures == wanted);
    vtkPolyData* output = reader->GetOutput();
    for (vtkIdType cell = 0; cell < output->GetNumberOfPolys(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      output->GetPolys()->GetCellAtId(cell, count, ids);
      for (vtkIdType i = 0; i < count; ++i)
      {
        RELIEVO_CHECK(ids[i] >= 0 && ids[i] < output->GetNumberOfPoints());
      }
    }
  }
  std::cout << refused << " of " << rounds << " broken files refused, the others read\n";
  RELIEVO_CHECK(refused > rounds / 2 && refused < rounds);
}

void TestRealMeshes()
{
  const struct
  {
    const char* Name;
    vtkIdType Points;
    vtkIdType Faces;
  } meshes[] = { { "bunny.off", 37706, 75408 }, { "armadillo.off", 26002, 52000 },
    { "elephant.off", 44460, 88928 } };
  for (const auto& mesh : meshes)
  {
    vtkNew<vtkRelievoOFFReader> reader;
    reader->SetFileName(relievoTest::DataFile(mesh.Name).c_str());
    reader->Update();
    RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == mesh.Points);
    RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPolys() == mesh.Faces);
    double bounds[6];
    reader->GetOutput()->GetBounds(bounds);
    RELIEVO_CHECK(bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] < bounds[5]);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testOFFReader)
{
  relievoTest::Session session;
  Path = relievoTest::OutputFolder() + "/mesh.off";
  TestPlain();
  TestArrays();
  TestFaces();
  TestRefusals();
  TestMutations();
  TestRealMeshes();
  return session.Result();
}
}
