// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of trees for rays: for the same data, for other data, and damaged. That answers are those
// of the scene that was written is checked by testRays.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoRayHash.h>
#include <vtkRelievoRayScene.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace testRayFiles
{
namespace
{
const char* const File = "data.rays";

std::string ReadBytes(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
}

void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// Reads a file; returns the error, or an empty text.
std::string Read(vtkRelievoRayScene* scene, const std::string& path)
{
  std::string error;
  vtkNew<vtkCallbackCommand> take;
  take->SetClientData(&error);
  take->SetCallback([](vtkObject*, unsigned long, void* own, void* text) {
    *static_cast<std::string*>(own) = static_cast<const char*>(text);
  });
  const unsigned long tag = scene->AddObserver(vtkCommand::ErrorEvent, take);
  const bool read = scene->Read(path);
  scene->RemoveObserver(tag);
  RELIEVO_CHECK(read == error.empty());
  return error;
}

vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(12);
  sphere->Update();
  return sphere->GetOutput();
}

// Distances of first hits along z, of a grid of rays.
std::vector<double> Trace(vtkRelievoRayScene* scene)
{
  vtkNew<vtkDoubleArray> origins, directions;
  origins->SetNumberOfComponents(3);
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < 400; ++i)
  {
    origins->InsertNextTuple3(0.05 * (i % 20) - 0.47, 0.05 * (i / 20) - 0.48, -9.0);
    directions->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  vtkNew<vtkTable> hits, all;
  RELIEVO_CHECK(scene->FindNearest(origins, directions, hits));
  RELIEVO_CHECK(scene->FindAll(origins, directions, all));
  std::vector<double> distances;
  auto* column = vtkDataArray::SafeDownCast(hits->GetColumnByName("distance"));
  for (vtkIdType i = 0; column && i < column->GetNumberOfTuples(); ++i)
  {
    distances.push_back(column->GetComponent(i, 0));
  }
  return distances;
}

// Nothing is built for the same data; later changes are followed.
void TestSameData()
{
  const auto sphere = MakeSphere();
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 0.1);
  vtkNew<vtkImageData> box;
  box->SetDimensions(3, 3, 3);
  box->SetSpacing(0.2, 0.2, 0.2);
  const auto fill = [&](vtkRelievoRayScene* scene) {
    scene->AddData(sphere, matrix);
    scene->AddData(box);
  };
  vtkNew<vtkRelievoRayScene> first;
  fill(first);
  RELIEVO_CHECK(first->Write(File));
  RELIEVO_CHECK(first->GetNumberOfMeshesBuilt() == 2);
  const std::string bytes = ReadBytes(File);
  vtkNew<vtkRelievoRayScene> second;
  fill(second);
  RELIEVO_CHECK(second->Read(File));
  RELIEVO_CHECK(Trace(second) == Trace(first));
  RELIEVO_CHECK(second->GetNumberOfMeshesBuilt() == 0 && second->GetNumberOfProps() == 2);
  // Read into a scene that has its own trees.
  RELIEVO_CHECK(first->Read(File) && !first->Update() && Trace(second) == Trace(first));
  second->Write(File);
  RELIEVO_CHECK(ReadBytes(File) == bytes);

  vtkNew<vtkRelievoRayScene> alone;
  RELIEVO_CHECK(alone->Read(File));
  RELIEVO_CHECK(alone->GetNumberOfProps() == 2 && !alone->GetPropData(0));
  RELIEVO_CHECK(alone->Write("again.rays") && ReadBytes("again.rays") == bytes);
  vtkNew<vtkRelievoRayScene> copy;
  copy->CopyStateOf(first);
  RELIEVO_CHECK(copy->Write("copy.rays") && ReadBytes("copy.rays") == bytes);
  // All meshes without strips have one empty array of VTK's.
  vtkNew<vtkPolyData>()->GetStrips()->Modified();
  RELIEVO_CHECK(Trace(alone) == Trace(first) && alone->GetNumberOfMeshesBuilt() == 0);
  {
    relievoTest::ExpectMessage expect("read from a file, which has no cells");
    alone->CopyMesh(0, vtkNew<vtkPolyData>());
  }
  {
    relievoTest::ExpectMessage expect("given a scene of a file");
    first->CopyStateOf(alone);
  }
  {
    relievoTest::ExpectMessage expect("called with a scene of a file");
    vtkNew<vtkDoubleArray> none;
    none->SetNumberOfComponents(3);
    RELIEVO_CHECK(!first->FindMoved(alone, none, none, vtkNew<vtkTable>(), none));
  }

  sphere->GetPoints()->SetPoint(7, 0.0, 0.0, -3.0);
  sphere->GetPoints()->Modified();
  vtkNew<vtkRelievoRayScene> anew;
  fill(anew);
  RELIEVO_CHECK(Trace(second) == Trace(anew));
  RELIEVO_CHECK(Trace(second) != Trace(alone));
  {
    relievoTest::ExpectMessage expect("of another scene: its points, cells or matrices differ");
    RELIEVO_CHECK(!anew->Read(File));
  }
  RELIEVO_CHECK(Trace(second) == Trace(anew));
  alone->AddData(sphere, matrix);
  RELIEVO_CHECK(alone->GetNumberOfMeshes() == 0);
  alone->AddData(box);
  RELIEVO_CHECK(Trace(alone) == Trace(anew) && alone->GetNumberOfProps() == 2);
}

// Meshes that were one when the file was written change apart.
void TestSharedTree()
{
  const auto sphere = MakeSphere();
  vtkNew<vtkMatrix4x4> left, right;
  left->SetElement(0, 3, -0.25);
  right->SetElement(0, 3, 0.25);
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(sphere, left);
  scene->AddData(sphere, right);
  RELIEVO_CHECK(scene->Write(File));
  vtkNew<vtkPolyData> first, second;
  first->DeepCopy(sphere);
  second->DeepCopy(sphere);
  const auto fill = [&](vtkRelievoRayScene* filled) {
    filled->AddData(first, left);
    filled->AddData(second, right);
  };
  vtkNew<vtkRelievoRayScene> read, anew;
  fill(read);
  RELIEVO_CHECK(read->Read(File) && Trace(read) == Trace(scene));
  RELIEVO_CHECK(read->GetNumberOfMeshesBuilt() == 0);
  second->GetPoints()->SetPoint(7, 0.0, 0.0, -3.0);
  second->GetPoints()->Modified();
  RELIEVO_CHECK(read->Update());
  RELIEVO_CHECK(read->GetNumberOfMeshesBuilt() + read->GetNumberOfMeshesRefitted() == 1);
  fill(anew);
  RELIEVO_CHECK(Trace(read) == Trace(anew) && !read->Update());
}

void AddActor(vtkRenderer* renderer, vtkMapper* mapper, double opacity)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}

// The trees of opaque meshes are kept between queries.
void TestOpaqueOnly()
{
  vtkNew<vtkRenderer> renderer;
  for (const double opacity : { 0.5, 1.0 })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeSphere());
    AddActor(renderer, mapper, opacity);
  }
  vtkNew<vtkRelievoRayScene> scene, read;
  scene->SetRenderer(renderer);
  RELIEVO_CHECK(scene->Write(File) && read->Read(File));
  RELIEVO_CHECK(read->GetNumberOfMeshes() == 2);
  read->OpaqueOnlyOn();
  RELIEVO_CHECK(read->Update() && read->GetNumberOfMeshes() == 1);
  RELIEVO_CHECK(!read->Update() && !read->Update());
  read->OpaqueOnlyOff();
  RELIEVO_CHECK(read->Update() && read->GetNumberOfMeshes() == 2 && Trace(read) == Trace(scene));
}

// Other points, another order of points, and other matrices are found.
void TestOtherData()
{
  const auto refuses = [](vtkPolyData* mesh, vtkMatrix4x4* matrix) {
    vtkNew<vtkRelievoRayScene> scene;
    scene->AddData(mesh, matrix);
    return Read(scene, File).find("of another scene") != std::string::npos;
  };
  const auto sphere = MakeSphere();
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(sphere);
  RELIEVO_CHECK(scene->Write(File));
  RELIEVO_CHECK(!refuses(sphere, nullptr));
  vtkNew<vtkMatrix4x4> matrix;
  RELIEVO_CHECK(!refuses(sphere, matrix));
  matrix->SetElement(1, 3, 1e-12);
  RELIEVO_CHECK(refuses(sphere, matrix));
  double place[3];
  sphere->GetPoint(5, place);
  sphere->GetPoints()->SetPoint(5, place[0], place[1], place[2] + 1e-6);
  RELIEVO_CHECK(refuses(sphere, nullptr));
  sphere->GetPoints()->SetPoint(5, place);
  RELIEVO_CHECK(!refuses(sphere, nullptr));
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(sphere->GetPolys());
  const vtkIdType turned[] = { 3, 1, 0 };
  cells->ReplaceCellAtId(0, 3, turned);
  sphere->SetPolys(cells);
  RELIEVO_CHECK(refuses(sphere, nullptr));
}

std::string GetFault(const std::string& bytes)
{
  WriteBytes("damaged.rays", bytes);
  vtkNew<vtkRelievoRayScene> scene;
  return Read(scene, "damaged.rays");
}

bool Says(const std::string& bytes, const std::string& text)
{
  const std::string fault = GetFault(bytes);
  return fault.find("damaged.rays: ") != std::string::npos && fault.find(text) != std::string::npos;
}

// Writes a value over the bytes, and their right hash.
template <typename Value>
std::string Change(std::string bytes, std::size_t at, const Value& value)
{
  std::memcpy(&bytes[at], &value, sizeof(value));
  vtkRelievoRayHash hash;
  hash.Add(bytes.data() + 64, bytes.size() - 64);
  const std::uint64_t number = hash.Get();
  std::memcpy(&bytes[24], &number, 8);
  return bytes;
}

constexpr std::size_t Glyphs = 40;

std::string WriteGlyphs()
{
  vtkNew<vtkPoints> points;
  for (std::size_t i = 0; i < Glyphs; ++i)
  {
    points->InsertNextPoint(0.1 * (i % 8) - 0.4, 0.2 * (i / 8) - 0.4, 0.0);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceData(MakeSphere());
  mapper->SetScaleFactor(0.1);
  vtkNew<vtkRenderer> renderer;
  AddActor(renderer, mapper, 1.0);
  vtkNew<vtkRelievoRayScene> scene;
  scene->SetRenderer(renderer);
  RELIEVO_CHECK(scene->Write("glyphs.rays"));
  return ReadBytes("glyphs.rays");
}

// Numbers that only these checks refuse, under a right hash.
void TestNumbers(const std::string& good, const std::string& glyphs)
{
  const char* const unfit = "its numbers do not fit each other";
  // Before the end: numbers of the glyphs' points, and their matrices.
  const std::size_t matrices = glyphs.size() - (64 + Glyphs * 8) - Glyphs * 128;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RELIEVO_CHECK(GetFault(Change(glyphs, matrices + 128 + 96, 0.125)).empty());
  RELIEVO_CHECK(Says(Change(glyphs, matrices + 128 + 96, nan), unfit));
  RELIEVO_CHECK(Says(Change(glyphs, matrices + 5 * 128 + 120, 2.0), unfit)); // the last row
  // The first tree begins with its origin, box and scale, then the number of its first polygon.
  const std::size_t origin = 64 + 128 + 64;
  const std::size_t cell = origin + 128 + 64;
  for (const std::size_t number : { 0, 4, 8, 9 })
  {
    RELIEVO_CHECK(Says(Change(good, origin + 8 * number, nan), unfit));
  }
  RELIEVO_CHECK(Says(Change(good, cell, std::int64_t(1) << 62), unfit));
  WriteBytes("damaged.rays", Change(good, cell, std::int64_t(1000)));
  vtkNew<vtkRelievoRayScene> alone, live;
  RELIEVO_CHECK(alone->Read("damaged.rays"));
  live->AddData(MakeSphere());
  RELIEVO_CHECK(Read(live, "damaged.rays").find(unfit) != std::string::npos);
}

void TestDamage()
{
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(MakeSphere());
  RELIEVO_CHECK(scene->Write(File));
  const std::string good = ReadBytes(File);
  RELIEVO_CHECK(GetFault(good).empty());
  std::mt19937_64 lots(11);
  const auto draw = [&lots](std::size_t count) { return static_cast<std::size_t>(lots() % count); };
  for (int i = 0; i < 300; ++i)
  {
    std::string bytes = good;
    char& byte = bytes[i < 64 ? static_cast<std::size_t>(i) : draw(bytes.size())];
    byte = static_cast<char>(byte ^ (1 << draw(8)));
    RELIEVO_CHECK(Says(bytes, ""));
  }
  for (int i = 0; i < 100; ++i)
  {
    RELIEVO_CHECK(Says(good.substr(0, i < 20 ? 10 * draw(12) : draw(good.size())), ""));
  }
  RELIEVO_CHECK(Says(good + std::string(64, '\0'), "is damaged: it has"));
  RELIEVO_CHECK(Says("ply\n" + good, "is no file of a tree for rays"));
  std::string other = good;
  other[8] = 2;
  RELIEVO_CHECK(Says(other, "has version 2 of the format, expected 1"));
  other = good;
  std::swap(other[12], other[15]);
  std::swap(other[13], other[14]);
  RELIEVO_CHECK(Says(other, "the other byte order"));

  // Wrong numbers under a right hash: refused, or harmless.
  const std::string glyphs = WriteGlyphs();
  RELIEVO_CHECK(GetFault(glyphs).empty());
  TestNumbers(good, glyphs);
  int refused = 0;
  for (int i = 0; i < 600; ++i)
  {
    std::string bytes = i % 2 == 0 ? good : glyphs;
    for (std::size_t k = 0; k <= draw(3); ++k)
    {
      const std::int32_t numbers[] = { -1, 0, 1, 1 << 20, -(1 << 20), 2147483647, -2147483647 - 1,
        static_cast<std::int32_t>(draw(400)) };
      // Small arrays come first and last.
      const std::size_t words = (bytes.size() - 64) / 4;
      const std::size_t near = draw(400);
      const std::size_t word = i % 3 == 0 ? draw(words) : i % 3 == 1 ? near : words - 1 - near;
      std::memcpy(&bytes[64 + 4 * word], &numbers[draw(8)], 4);
    }
    WriteBytes("damaged.rays", Change(bytes, 64, bytes[64]));
    vtkNew<vtkRelievoRayScene> damaged;
    if (Read(damaged, "damaged.rays").empty())
    {
      Trace(damaged);
    }
    else
    {
      ++refused;
    }
  }
  RELIEVO_CHECK(refused > 100 && refused < 600);
}

// Threads that write one file do not disturb each other, and leave nothing else.
void TestThreads()
{
  std::vector<std::thread> threads;
  bool written[] = { true, true, true };
  for (bool& each : written)
  {
    threads.emplace_back([&each]() {
      vtkNew<vtkRelievoRayScene> scene;
      scene->AddData(MakeSphere());
      for (int i = 0; i < 20; ++i)
      {
        each = scene->Write("threads.rays") && each;
      }
    });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  RELIEVO_CHECK(written[0] && written[1] && written[2]);
  RELIEVO_CHECK(GetFault(ReadBytes("threads.rays")).empty());
  for (const auto& entry : std::filesystem::directory_iterator("."))
  {
    RELIEVO_CHECK(entry.path().extension() != ".tmp");
  }
}

// An error gives its reason, and leaves the scene and the file as they were.
void TestPlaces()
{
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(MakeSphere());
  {
    relievoTest::ExpectMessage expect("No such file or directory");
    RELIEVO_CHECK(!scene->Write("no such folder/data.rays"));
  }
  {
    relievoTest::ExpectMessage expect("No such file or directory");
    RELIEVO_CHECK(!scene->Read("no such file.rays"));
  }
  {
    relievoTest::ExpectMessage expect("is no file of a tree for rays");
    RELIEVO_CHECK(!scene->Read("."));
  }
  const std::vector<double> distances = Trace(scene);
  RELIEVO_CHECK(distances.size() == 400 && distances[210] > 8.4 && distances[210] < 8.6);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testRayFiles)
{
  relievoTest::Session session;
  TestSameData();
  TestSharedTree();
  TestOpaqueOnly();
  TestOtherData();
  TestDamage();
  TestThreads();
  TestPlaces();
  return session.Result();
}
}
