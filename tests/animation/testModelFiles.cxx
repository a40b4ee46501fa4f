// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are missing, empty, of another kind, or cut anywhere: one message or a model, nothing
// half loaded, no crash; and a file that changes is read again.
#include "Check.h"
#include "FileBytes.h"
#include "ReaderErrors.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <sys/stat.h>
#include <utility>

namespace testModelFiles
{
namespace
{
using namespace relievoTest;

void ExpectRefusal(const std::string& path, const std::string& words)
{
  const ExpectMessage expect(words);
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  reader->UpdateTimeStep(0.5);
  RELIEVO_CHECK(expect.Count() == 1);
  RELIEVO_CHECK(reader->GetErrorCode() != 0);
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfBlocks() == 0);
  RELIEVO_CHECK(reader->GetNumberOfAnimations() == 0);
  auto* skeleton = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1));
  RELIEVO_CHECK(skeleton && skeleton->GetNumberOfPoints() == 0);
}

void TestNoModel()
{
  const std::string folder = OutputFolder();
  ExpectRefusal(folder + "/missing.fbx", "there is no such file");
  const std::string pipe = folder + "/pipe.fbx";
  std::filesystem::remove(pipe);
  RELIEVO_CHECK(mkfifo(pipe.c_str(), 0600) == 0);
  ExpectRefusal(pipe, "it is a pipe");
  std::filesystem::remove(pipe);
  Store(folder + "/empty.dae", "");
  ExpectRefusal(folder + "/empty.dae", "empty.dae");
  Store(folder + "/text.bvh", "This is not a motion.");
  ExpectRefusal(folder + "/text.bvh", "text.bvh");
  Store(folder + "/model.unknown", "?");
  ExpectRefusal(folder + "/model.unknown", "model.unknown");
  RELIEVO_CHECK(!vtkRelievoModelReader::CanReadFile((folder + "/model.unknown").c_str()));
  RELIEVO_CHECK(!vtkRelievoModelReader::CanReadFile((folder + "/missing.fbx").c_str()));
  RELIEVO_CHECK(!vtkRelievoModelReader::CanReadFile(nullptr));
  const ExpectMessage expect("no file name is set");
  vtkNew<vtkRelievoModelReader> reader;
  reader->Update();
  RELIEVO_CHECK(expect.Count() == 1);
}

// Cut anywhere, a file is refused with its name or read as far as its format says: of those that
// end where they are cut, at least the empty file and `least` others are refused.
void TestCut(const std::string& name, int least)
{
  const std::string whole = Load(DataFile("models/" + name));
  const std::string extension = std::filesystem::path(name).extension().string();
  int refused = 0;
  constexpr int Cuts = 12;
  for (int i = 0; i < Cuts; ++i)
  {
    const std::string path = OutputFolder() + "/cut" + std::to_string(i) + extension;
    Store(path, whole.substr(0, whole.size() * static_cast<std::size_t>(i) / Cuts));
    vtkNew<vtkRelievoModelReader> reader;
    reader->SetFileName(path.c_str());
    const int messages = CountErrors(reader);
    RELIEVO_CHECK(messages == (reader->GetErrorCode() != 0 ? 1 : 0));
    RELIEVO_CHECK(reader->GetErrorCode() == 0 || reader->GetOutput()->GetNumberOfBlocks() == 0);
    refused += messages;
    std::filesystem::remove(path);
  }
  std::cout << name << ": " << refused << " of " << Cuts << " cut copies refused\n";
  RELIEVO_CHECK_THAT(refused > least, name + ": " + std::to_string(refused) + " are refused");
}

// A face of a point that is not there is refused, before Assimp's own steps read beyond the points.
void TestStrangePoint()
{
  std::string text = Load(DataFile("models/IQM/mrfixit.iqm"));
  constexpr std::size_t placeOfTriangles = 60; // of the header: where the triangles begin
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, text.data() + placeOfTriangles, 4);
  if (RELIEVO_CHECK(triangles + 4 < text.size()))
  {
    const std::uint32_t far = 0x7fffffff;
    std::memcpy(&text[triangles], &far, 4);
    const std::string path = OutputFolder() + "/strange.iqm";
    Store(path, text);
    ExpectRefusal(path, "has a face of point 2147483647");
  }
}

// A file that is written twice within a second, and one that the model's own names, are read again.
void TestReadAgainAtOnce()
{
  const std::string path = OutputFolder() + "/twice.bvh";
  const std::string whole = Load(DataFile("models/BVH/01_01.bvh"));
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(path.c_str());
  const auto read = [&]() {
    reader->Modified();
    reader->Update();
    return vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1))->GetNumberOfPoints();
  };
  const std::string one = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\nEnd Site\n{\n"
                          "OFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0\n";
  Store(path, one);
  const vtkIdType few = read();
  Store(path, whole);
  RELIEVO_CHECK(read() > few && few > 0);
  Store(path, one);
  RELIEVO_CHECK(read() == few);
  std::filesystem::remove(path);

  const std::string folder = "models/glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/";
  const std::string text = Load(DataFile(folder + "AnimatedMorphCube.gltf"));
  std::string buffer = Load(DataFile(folder + "AnimatedMorphCube.bin"));
  Store(OutputFolder() + "/AnimatedMorphCube.bin", buffer);
  const std::string model = OutputFolder() + "/named.gltf";
  Store(model, text);
  reader->SetFileName(model.c_str());
  reader->Update();
  double first[6];
  double second[6];
  vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(0))->GetBounds(first);
  std::fill(buffer.begin() + 672, buffer.begin() + 960, '\0'); // all points in one
  Store(OutputFolder() + "/AnimatedMorphCube.bin", buffer);
  reader->Modified();
  reader->Update();
  auto* flat = vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(0));
  if (RELIEVO_CHECK(flat))
  {
    flat->GetBounds(second);
    RELIEVO_CHECK(first[1] - first[0] > 0.001 && second[1] - second[0] == 0.);
  }
  // And not when nothing has changed.
  vtkDataArray* kept = flat ? flat->GetPointData()->GetArray("joints") : nullptr;
  reader->Modified();
  reader->Update();
  RELIEVO_CHECK(kept &&
    vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(0))
        ->GetPointData()
        ->GetArray("joints") == kept);
}

// The file's new content shows after Modified(), and after the name changes.
void TestReadAgain()
{
  const std::string path = OutputFolder() + "/changing.bvh";
  const std::string text = Load(DataFile("models/BVH/01_01.bvh"));
  vtkNew<vtkRelievoModelReader> reader;
  {
    const ExpectMessage expect("changing.bvh");
    std::filesystem::remove(path);
    reader->SetFileName(path.c_str());
    reader->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  Store(path, text);
  reader->Modified();
  reader->Update();
  RELIEVO_CHECK(reader->GetErrorCode() == 0 && reader->GetOutput()->GetNumberOfBlocks() == 1);
  RELIEVO_CHECK(reader->GetNumberOfAnimations() == 1);
  std::filesystem::remove(path);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelFiles)
{
  relievoTest::Session session;
  TestNoModel();
  TestReadAgain();
  TestReadAgainAtOnce();
  TestStrangePoint();
  const std::pair<const char*, int> cut[] = { { "FBX/huesitos.fbx", 11 }, { "IQM/mrfixit.iqm", 11 },
    { "X/test_cube_binary.x", 11 }, { "MS3D/Wuson.ms3d", 10 }, { "MDL/MDL (HL1)/man.mdl", 11 },
    { "Collada/box_nested_animation.dae", 11 }, { "glTF2/simple_skin/simple_skin.gltf", 11 },
    { "B3D/WusonBlitz.b3d", 11 }, { "LWS/move_xz_hermite.lws", 1 },
    { "3DS/RotatingCube.3DS", 11 } };
  for (const auto& [name, least] : cut)
  {
    TestCut(name, least);
  }
  return session.Result();
}
}
