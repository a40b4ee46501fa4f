// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Images inside of models' files, against the colours that were written into them: glTF with bytes
// of PNG, JPEG, BMP and TGA, in its binary form and as text; damaged ones; those of FBX, and bare
// texels.
#include "Check.h"
#include "GltfScene.h"
#include "ReaderErrors.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testModelTextures
{
namespace
{
using namespace relievoTest;

// Another colour at each place; large plain fields, for JPEG.
void ColorOf(int x, int y, int color[3])
{
  color[0] = 40 + 100 * (x / 8);
  color[1] = 30 + 90 * (y / 8);
  color[2] = 200 - 60 * (x / 8) - 50 * (y / 8);
}

template <typename Writer>
std::string MakeBytes()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 24, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 24; ++y)
  {
    for (int x = 0; x < 16; ++x)
    {
      int color[3];
      ColorOf(x, y, color);
      for (int i = 0; i < 3; ++i)
      {
        image->SetScalarComponentFromDouble(x, y, 0, i, color[i]);
      }
    }
  }
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return std::string(
    reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
}

// By the formats' descriptions: the lowest row first, blue first.
std::string MakeRows()
{
  std::string rows;
  for (int y = 0; y < 24; ++y)
  {
    for (int x = 0; x < 16; ++x)
    {
      int color[3];
      ColorOf(x, y, color);
      rows +=
        { static_cast<char>(color[2]), static_cast<char>(color[1]), static_cast<char>(color[0]) };
    }
  }
  return rows;
}

std::string MakeTGA()
{
  std::string header(18, '\0');
  header[2] = 2;
  header[12] = 16;
  header[14] = 24;
  header[16] = 24;
  return header + MakeRows();
}

std::string MakeBMP()
{
  std::string header(54, '\0');
  header.replace(0, 2, "BM");
  header[10] = 54;
  header[14] = 40;
  header[18] = 16;
  header[22] = 24;
  header[26] = 1;
  header[28] = 24;
  return header + MakeRows();
}

// A triangle whose colour and whose normals are of this image; a path that ends in .glb has the
// image's bytes in its own, another one as text.
void WriteModel(const std::string& path, const std::string& image, const std::string& type)
{
  const std::vector<float> numbers = { 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, // places
    0.f, 1.f, 1.f, 1.f, 0.f, 0.f };                                                 // coordinates
  std::string bytes(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
  const bool binary = IsGlb(path);
  std::string more;
  std::string source;
  if (binary)
  {
    more = R"(,{"buffer":0,"byteOffset":60,"byteLength":)" + std::to_string(image.size()) + "}";
    source = R"("bufferView":2,"mimeType":"image/)" + type + "\"";
    bytes += image;
  }
  else
  {
    source = R"("uri":"data:image/)" + type + ";base64," + EncodeBytes(image) + "\"";
  }
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  const std::string text =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],)"
    R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},)"
    R"("normalTexture":{"index":0,"scale":0.25}}],)"
    R"("textures":[{"source":0}],"images":[{)" +
    source + R"(}],"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
    WriteGltfUri(path, bytes) +
    R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},)"
    R"({"buffer":0,"byteOffset":36,"byteLength":24})" +
    more +
    R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
    R"("min":[0,0,0],"max":[1,1,0]},)"
    R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}]})";
  WriteGltfFile(path, text, bytes);
}

vtkPolyData* GetMesh(vtkRelievoModelReader* reader, unsigned int block = 0)
{
  return vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(block));
}

std::string GetName(vtkPolyData* mesh, const char* array)
{
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(array));
  return names ? names->GetValue(0) : "";
}

// The largest error over all pixels, or only those in the fields.
double LargestOff(vtkImageData* image, bool all)
{
  double off = 0.;
  for (int y = 0; y < 24; ++y)
  {
    for (int x = 0; x < 16; ++x)
    {
      int color[3];
      ColorOf(x, y, color);
      const bool inner = x % 8 > 1 && x % 8 < 6 && y % 8 > 1 && y % 8 < 6;
      for (int i = 0; i < 3 && (all || inner); ++i)
      {
        off = Larger(off, std::abs(image->GetScalarComponentAsDouble(x, y, 0, i) - color[i]));
      }
    }
  }
  return off;
}

void TestWritten()
{
  const std::string png = MakeBytes<vtkPNGWriter>();
  const std::string jpeg = MakeBytes<vtkJPEGWriter>();
  const std::string bmp = MakeBMP();
  const std::string tga = MakeTGA();
  struct
  {
    const char* Path;
    const std::string& Bytes;
    const char* Type;
    double Slack;
  } const cases[] = { { "textured.glb", png, "png", 0. }, { "textured.gltf", png, "png", 0. },
    { "bitmap.glb", bmp, "bmp", 0. }, { "targa.glb", tga, "tga", 0. },
    { "targa.gltf", tga, "tga", 0. }, { "photo.glb", jpeg, "jpeg", 12. },
    { "photo.gltf", jpeg, "jpeg", 12. } };
  for (const auto& each : cases)
  {
    WriteModel(each.Path, each.Bytes, each.Type);
    vtkNew<vtkRelievoModelReader> reader;
    reader->SetFileName(each.Path);
    RELIEVO_CHECK(CountErrors(reader) == 0);
    vtkPolyData* mesh = GetMesh(reader);
    if (!RELIEVO_CHECK(mesh != nullptr))
    {
      continue;
    }
    for (const char* array : { "base_color_texture", "normal_texture" })
    {
      const std::string name = GetName(mesh, array);
      RELIEVO_CHECK_THAT(
        reader->HasEmbeddedTexture(name.c_str()), std::string(each.Path) + " has no " + array);
      vtkImageData* image = reader->GetEmbeddedTexture(name.c_str());
      if (RELIEVO_CHECK(
            image && image->GetDimensions()[0] == 16 && image->GetDimensions()[1] == 24))
      {
        // The lowest row first, at v = 0: Assimp turns glTF's coordinates over.
        RELIEVO_CHECK_AT_MOST(
          LargestOff(image, each.Slack == 0.), each.Slack, std::string(each.Path) + ": colours");
      }
      RELIEVO_CHECK(reader->GetEmbeddedTexture(name.c_str()) == image);
    }
    const double* lowest = mesh->GetPointData()->GetTCoords()->GetTuple2(0);
    RELIEVO_CHECK(lowest[1] == mesh->GetPoint(0)[1]);
    vtkDataArray* strength = mesh->GetFieldData()->GetArray("normal_strength");
    RELIEVO_CHECK(strength && strength->GetComponent(0, 0) == 0.25);
    RELIEVO_CHECK(!reader->HasEmbeddedTexture("*7") && !reader->GetEmbeddedTexture("*7"));
    RELIEVO_CHECK(!reader->HasEmbeddedTexture(nullptr) && !reader->GetEmbeddedTexture(nullptr));
  }
}

// Whatever is done to the bytes: no image, and one error.
void TestDamaged()
{
  const std::string whole = MakeBytes<vtkPNGWriter>();
  for (std::size_t i = 0; i < 40; ++i)
  {
    std::string bytes = whole;
    const std::size_t at = i * bytes.size() / 40;
    if (i % 2 == 0)
    {
      bytes.resize(std::min(at + 4, bytes.size() - 1));
    }
    else
    {
      bytes[at] = static_cast<char>(bytes[at] ^ 0x5A);
    }
    WriteModel("damaged.glb", bytes, "png");
    vtkNew<vtkRelievoModelReader> reader;
    reader->SetFileName("damaged.glb");
    RELIEVO_CHECK(CountErrors(reader) == 0);
    const std::string name = GetName(GetMesh(reader), "base_color_texture");
    RELIEVO_CHECK(reader->HasEmbeddedTexture(name.c_str()));
    ExpectMessage expect("the image '" + name + "' in it");
    RELIEVO_CHECK(!reader->GetEmbeddedTexture(name.c_str()));
    RELIEVO_CHECK(!reader->GetEmbeddedTexture(name.c_str()));
    RELIEVO_CHECK(expect.Count() == 1);
  }
}

// Models of Debian's assimp-testmodels: FBX with media inside, and texels of an old game.
void TestModels()
{
  const char* const paths[] = { "textured/FBX/embedded_ascii/box_embedded_texture_fragmented.fbx",
    "textured/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb",
    "textured/glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf",
    "textured/MDL/MDL3 (3DGS A4)/minigun.MDL" };
  for (const char* path : paths)
  {
    vtkNew<vtkRelievoModelReader> reader;
    reader->SetFileName(DataFile(path).c_str());
    RELIEVO_CHECK(CountErrors(reader) == 0);
    int images = 0;
    for (unsigned int i = 0; i < reader->GetOutput()->GetNumberOfBlocks(); ++i)
    {
      vtkPolyData* mesh = GetMesh(reader, i);
      const std::string name = mesh ? GetName(mesh, "base_color_texture") : "";
      vtkImageData* image = reader->GetEmbeddedTexture(name.c_str());
      images += image ? 1 : 0;
      RELIEVO_CHECK_THAT(image && image->GetDimensions()[0] > 1 && image->GetDimensions()[1] > 1 &&
          image->GetScalarRange()[1] > image->GetScalarRange()[0],
        std::string(path) + ": no image of mesh " + std::to_string(i) + ", '" + name + "'");
    }
    RELIEVO_CHECK_THAT(images > 0, std::string(path) + ": no images");
  }
}

// An embedded texture is the picture that another copy of the model has in a file of its own.
void TestAgainstFile()
{
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(
    DataFile("textured/glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf").c_str());
  reader->Update();
  vtkImageData* image =
    reader->GetEmbeddedTexture(GetName(GetMesh(reader), "base_color_texture").c_str());
  const std::string path = DataFile("textured/glTF2/BoxTextured-glTF/CesiumLogoFlat.png");
  vtkNew<vtkPNGReader> file;
  file->SetFileName(path.c_str());
  file->Update();
  vtkDataArray* a = image->GetPointData()->GetScalars();
  vtkDataArray* b = file->GetOutput()->GetPointData()->GetScalars();
  RELIEVO_CHECK(a->GetNumberOfValues() == b->GetNumberOfValues() && a->GetNumberOfValues() > 1000);
  int other = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    other += a->GetVariantValue(i) == b->GetVariantValue(i) ? 0 : 1;
  }
  RELIEVO_CHECK_AT_MOST(other, 0, "numbers that differ from the image's file");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelTextures)
{
  relievoTest::Session session;
  TestWritten();
  TestDamaged();
  TestModels();
  TestAgainstFile();
  return session.Result();
}
}
