// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Copies of rigged models with bytes changed, cut out or cut off, equal in every run: each is read
// or refused with one message, and no output refers to missing data.
//
// testModelMutants [FIRST COUNT FILE...] tries other seeds and files, for a sanitizer to watch.
#include "Check.h"
#include "FileBytes.h"
#include "ReaderErrors.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace testModelMutants
{
namespace
{
using namespace relievoTest;

// A number below the count; standard libraries agree on it, which distributions do not promise.
std::size_t Below(std::mt19937& random, std::size_t count)
{
  return count > 0 ? random() % count : 0;
}

std::string Mutate(std::string text, unsigned int seed)
{
  std::mt19937 random(seed);
  const std::size_t changes = 1 + Below(random, 3);
  for (std::size_t i = 0; i < changes; ++i)
  {
    const std::size_t at = Below(random, text.size());
    switch (Below(random, 8))
    {
      case 0: // a part is gone
        text.erase(at, 1 + Below(random, 64));
        break;
      case 1: // a part is there twice
        text.insert(at, text.substr(at, 1 + Below(random, 64)));
        break;
      case 2: // bits of a size, or of a number
        text.replace(at, 4, std::string(4, '\xff'));
        break;
      case 3: // the end is gone
        text.resize(seed % 4 == 0 ? at : text.size());
        break;
      default:
        if (!text.empty())
        {
          text[at] = static_cast<char>(text[at] ^ (1 << Below(random, 8)));
        }
    }
  }
  return text;
}

bool IsFinite(vtkDataArray* array)
{
  bool finite = array != nullptr;
  for (vtkIdType i = 0; finite && i < array->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < array->GetNumberOfComponents(); ++j)
    {
      finite = finite && std::isfinite(array->GetComponent(i, j));
    }
  }
  return finite;
}

// Returns the problem of a mesh at rest, or "".
std::string Judge(vtkPolyData* mesh, vtkPolyData* skeleton)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkDataArray* joints = mesh->GetPointData()->GetArray("joints");
  vtkDataArray* weights = mesh->GetPointData()->GetArray("weights");
  vtkDataArray* nodes = mesh->GetFieldData()->GetArray("bone_node");
  if (!joints || !weights || !nodes || joints->GetNumberOfTuples() != count ||
    weights->GetNumberOfTuples() != count)
  {
    return "joints, weights or bones are missing";
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int j = 0; j < joints->GetNumberOfComponents(); ++j)
    {
      const double joint = joints->GetComponent(i, j);
      if (!(joint >= -1. && joint < static_cast<double>(nodes->GetNumberOfTuples())))
      {
        return "a joint is none of the bones";
      }
    }
  }
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    const double node = nodes->GetComponent(i, 0);
    if (!(node >= 0. && node < static_cast<double>(skeleton->GetNumberOfPoints())))
    {
      return "a bone is no point of the skeleton";
    }
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> cell;
    mesh->GetCellPoints(i, cell);
    for (vtkIdType j = 0; j < cell->GetNumberOfIds(); ++j)
    {
      if (cell->GetId(j) < 0 || cell->GetId(j) >= count)
      {
        return "a cell has a point that is not there";
      }
    }
  }
  return IsFinite(mesh->GetPoints()->GetData()) && IsFinite(weights)
    ? ""
    : "points or weights are not finite";
}

// Whether it was read.
bool Try(const std::string& path, const std::string& what)
{
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetPose(vtkRelievoModelReader::POSE_REST);
  const int messages = CountErrors(reader);
  const bool read = reader->GetErrorCode() == 0;
  auto* skeleton = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1));
  RELIEVO_CHECK_THAT(
    messages == (read ? 0 : 1), what + ": " + std::to_string(messages) + " messages");
  RELIEVO_CHECK_THAT(
    read || reader->GetOutput()->GetNumberOfBlocks() == 0, what + ": half a model");
  RELIEVO_CHECK_THAT(read == (skeleton->GetNumberOfPoints() > 0), what + ": half a skeleton");
  for (unsigned int i = 0; read && i < reader->GetOutput()->GetNumberOfBlocks(); ++i)
  {
    auto* mesh = vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(i));
    const std::string error = mesh ? Judge(mesh, skeleton) : "no mesh";
    RELIEVO_CHECK_THAT(error.empty(), what + ": " + error);
  }
  reader->SetPose(vtkRelievoModelReader::POSE_ANIMATION);
  reader->UpdateTimeStep(0.3);
  return read;
}

void TestMutants(const std::string& name, int first, int count)
{
  const std::string whole = Load(DataFile("models/" + name));
  const std::string path =
    OutputFolder() + "/mutant" + std::filesystem::path(name).extension().string();
  int read = 0;
  for (int seed = first; seed < first + count; ++seed)
  {
    Store(path, Mutate(whole, static_cast<unsigned int>(seed)));
    read += Try(path, name + ", seed " + std::to_string(seed)) ? 1 : 0;
  }
  std::filesystem::remove(path);
  std::cout << name << ": " << read << " of " << count << " mutants are read\n";
  RELIEVO_CHECK_THAT(read > 0 && read < count, name + ": all are read, or none");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelMutants)
{
  relievoTest::Session session;
  const int first = argc > 2 ? std::atoi(argv[1]) : 0;
  const int count = argc > 2 ? std::atoi(argv[2]) : 100;
  std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
  if (names.empty())
  {
    // Assimp 5.2.5 crashes on some mutants of glTF, and does not return from some of Collada.
    names = { "FBX/huesitos.fbx", "IQM/mrfixit.iqm", "X/anim_test.x" };
  }
  for (const std::string& name : names)
  {
    TestMutants(name, first, count);
  }
  return session.Result();
}
}
