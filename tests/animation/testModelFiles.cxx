// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are missing, empty, of another kind, or cut anywhere: one message or a model, nothing
// half loaded, no crash; and a file that changes is read again.
#include "Check.h"
#include "Session.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace
{
using namespace relievoTest;

std::string Load(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void Store(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

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

// Cut anywhere, a file is refused with its name or read as far as its format says.
void TestCut(const std::string& name)
{
  const std::string whole = Load(DataFile("models/" + name));
  const std::string extension = std::filesystem::path(name).extension().string();
  int refused = 0;
  constexpr int Cuts = 12;
  for (int i = 0; i < Cuts; ++i)
  {
    const std::string path = OutputFolder() + "/cut" + std::to_string(i) + extension;
    Store(path, whole.substr(0, whole.size() * static_cast<std::size_t>(i) / Cuts));
    int messages = 0;
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&messages);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
    vtkNew<vtkRelievoModelReader> reader;
    reader->AddObserver(vtkCommand::ErrorEvent, count);
    reader->SetFileName(path.c_str());
    reader->Update();
    RELIEVO_CHECK(messages == (reader->GetErrorCode() != 0 ? 1 : 0));
    RELIEVO_CHECK(reader->GetErrorCode() == 0 || reader->GetOutput()->GetNumberOfBlocks() == 0);
    refused += messages;
    std::filesystem::remove(path);
  }
  std::cout << name << ": " << refused << " of " << Cuts << " cut copies refused\n";
  RELIEVO_CHECK(refused > 0);
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
int main()
{
  relievoTest::Session session;
  TestNoModel();
  TestReadAgain();
  for (const char* name : { "FBX/huesitos.fbx", "IQM/mrfixit.iqm", "X/test_cube_binary.x",
         "MS3D/Wuson.ms3d", "MDL/MDL (HL1)/man.mdl", "Collada/box_nested_animation.dae",
         "glTF2/simple_skin/simple_skin.gltf", "B3D/WusonBlitz.b3d", "LWS/move_xz_hermite.lws",
         "3DS/RotatingCube.3DS" })
  {
    TestCut(name);
  }
  return session.Result();
}
