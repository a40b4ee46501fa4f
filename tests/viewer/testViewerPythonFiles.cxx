// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files with materials, textures, bones, blocks and holes: the window's picture equals the command
// line's, byte for byte, and the Python program that the window copies says the same words.
#include "TestCase.h"
#include "ViewerTest.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <QtTest>

#include <cmath>
#include <string>
#include <vector>

namespace testViewerPythonFiles
{
class TestViewerPythonFiles : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  static std::string Data(const std::string& name)
  {
    return qgetenv("RELIEVO_DATA").toStdString() + "/" + name;
  }

  // A new scene of the words.
  void CompareAll(const std::vector<std::string>& words)
  {
    this->Window ? this->OpenAgain(words) : this->Open(words);
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->CompareBoth(words.back().c_str());
  }

  void CompareBoth(const char* what)
  {
    this->Compare(what);
    // testViewerPython draws pictures of its programs.
    const std::vector<std::string> words = this->Window->GetViewSettings().GetWords();
    QVERIFY2(this->RunPythonForWords() == scene::Settings::FromWords(words), what);
  }

  static vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
  }

  // A mesh with a point that is not finite, or with none.
  std::string WriteHoled(bool holed) const
  {
    const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(this->WriteScene());
    if (holed)
    {
      mesh->GetPoints()->SetPoint(3, 0.0, std::nan(""), 0.0);
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetDataModeToBinary(); // newer expats make Python's VTK refuse appended data
    writer->SetInputData(mesh);
    writer->SetFileName(this->Path("holed.vtp").c_str());
    writer->Write();
    return this->Path("holed.vtp");
  }

  // A mesh in a block of a block, a grid of points, and a block without anything.
  std::string WriteBlocks(bool grid, bool holed) const
  {
    vtkNew<vtkMultiBlockDataSet> inner;
    inner->SetBlock(0, ReadMesh(this->WriteHoled(holed)));
    inner->SetBlock(1, vtkNew<vtkPolyData>());
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, inner);
    if (grid)
    {
      vtkNew<vtkRTAnalyticSource> waves;
      waves->SetWholeExtent(0, 4, 0, 3, 0, 2);
      waves->Update();
      vtkImageData* image = waves->GetOutput();
      image->SetSpacing(0.3, 0.3, 0.3);
      image->SetOrigin(1.0, 0.3, 0.0);
      image->GetPointData()->GetScalars()->SetName("height");
      blocks->SetBlock(2, image);
    }
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetDataModeToBinary();
    writer->SetInputData(blocks);
    writer->SetFileName(this->Path("blocks.vtm").c_str());
    writer->Write();
    return this->Path("blocks.vtm");
  }

  // Two squares with texture coordinates, the second in another material.
  std::string WriteTexturedOBJ() const
  {
    this->WriteImage();
    this->WriteText("wall.mtl",
      "newmtl wall\nKd 1 1 1\nmap_Kd waves.png\n"
      "newmtl floor\nKd 0.5 0.9 0.5\nmap_Kd -s 2 3 1 -o 0.1 waves.png\n");
    this->WriteText("wall.obj",
      "mtllib wall.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl wall\nf 1/1 2/2 3/3 4/4\nusemtl floor\n"
      "f 1/1 2/2 6/3\nusemtl wall\nf 1/4 6/2 5/1\n");
    return this->Path("wall.obj");
  }

  // A square with a texture that the file turns, and a normal map or none, in files beside it;
  // opaque or not.
  std::string WriteGLTF(bool normals = true, bool blended = false) const
  {
    this->WriteImage();
    const float numbers[] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0,
      0, 1, 0, 1, 1, 1, 1, 0, 0, 0 };
    const unsigned short corners[] = { 0, 1, 2, 0, 2, 3 };
    QByteArray bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
    bytes.append(reinterpret_cast<const char*>(corners), sizeof corners);
    this->WriteText("square.gltf",
      R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"extensionsUsed": ["KHR_texture_transform"], "nodes": [{"mesh": 0, "name": "square"}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
  "indices": 3, "material": 0}]}],
"materials": [{"alphaMode": ")" +
        std::string(blended ? "BLEND" : "OPAQUE") + R"(",
  "pbrMetallicRoughness": {"metallicFactor": 0.2, "roughnessFactor": 0.4,
    "baseColorFactor": [1, 1, 1, 0.5],
    "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
      {"offset": [0.1, 0.2], "rotation": 0.3, "scale": [0.7, 0.6]}}}})" +
        std::string(normals ? R"(, "normalTexture": {"index": 1, "scale": 0.5})" : "") + R"(}],
"textures": [{"source": 0}, {"source": 1}], "images": [{"uri": "waves.png"}, {"uri": "waves.png"}],
"buffers": [{"byteLength": )" +
        std::to_string(bytes.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
        bytes.toBase64().toStdString() + R"("}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
  {"buffer": 0, "byteOffset": 48, "byteLength": 48},
  {"buffer": 0, "byteOffset": 96, "byteLength": 32},
  {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
    "min": [-1, -1, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
  {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
  {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
    return this->Path("square.gltf");
  }

private Q_SLOTS:
  void materialsOfOBJ()
  {
    const std::vector<std::string> light = { "--light", "sun:0.2,0.4,1", "--shadows", "exact" };
    for (const std::string& path : { this->WriteOBJ(), this->WriteOBJ(false) })
    {
      std::vector<std::string> words = light;
      words.push_back(path);
      this->CompareAll(words);
    }
    this->CompareAll({ "--color", "#3366cc", this->WriteScene(), this->WriteOBJ() });
  }

  // Shading by PBR takes a texture for sRGB, and leaves it as it was.
  void texturesOfOBJ()
  {
    const std::string path = this->WriteTexturedOBJ();
    this->CompareAll({ "--camera", "3,2,6,1,1,0,0,1,0", path });
    const vtkSmartPointer<vtkImageData> plain = this->Grab();
    this->Change([](scene::Settings& settings) { settings.Set("--shading", "pbr"); });
    this->CompareBoth("pbr");
    QVERIFY(CountDifferent(plain, this->Grab()) > 100);
    this->Change([](scene::Settings& settings) { settings.Remove("--shading"); });
    QCOMPARE(CountDifferent(plain, this->Grab()), 0);
    this->CompareAll({ "--shading", "pbr", "--color", "gray", path });
    this->CompareAll({ "--shading", "flat", "--normal-map", this->Path("waves.png"), path });
  }

  void glTF()
  {
    const std::string square = this->WriteGLTF();
    const std::string waves = this->Path("waves.png");
    this->CompareAll({ "--light", "sun:0.4,1,0.6", "--shadows", "map", square });
    this->CompareAll({ "--shading", "phong", "--edges", "--opacity", "0.5", square });
    this->CompareAll({ "--color", "#3366cc", square });
    this->CompareAll({ "--environment", waves, square });
    this->WriteGLTF(false);
    this->CompareAll({ "--normal-map", waves, "--environment", waves, square });
    const vtkSmartPointer<vtkImageData> opaque = this->Grab();
    this->WriteGLTF(false, true);
    this->CompareAll({ "--normal-map", waves, "--environment", waves, square });
#ifndef RELIEVO_VTK_PBR_OPACITY_OF_TEXTURES
    QVERIFY(CountDifferent(opaque, this->Grab()) > 100);
#endif
    this->CompareAll({ "--shading", "phong", "--opacity", "0.5", square });
    this->CompareAll({ Data("textured/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"), square });
  }

  void models()
  {
    const std::string square = this->WriteGLTF();
    this->CompareAll({ "--skin", "linear", "--light", "sun:0.4,1,0.6", square });
    this->CompareAll({ "--skin", "off", "--shading", "pbr", "--environment",
      this->Path("waves.png") + ",30", square, this->WriteScene() });
    this->CompareAll({ "--shading", "flat",
      Data("textured/FBX/embedded_ascii/box_embedded_texture_fragmented.fbx") });
    this->CompareAll({ "--time", "0.7", "--skeleton", "--loop", Data("models/BVH/01_01.bvh"),
      Data("models/X/Testwuson.X") });
    const std::string skin = Data("models/glTF2/simple_skin/simple_skin.gltf");
    this->CompareAll({ "--time", "1.5", "--skin", "dual-quaternion", skin });
    this->CompareAll({ "--skeleton", "--environment", this->Path("waves.png"), skin });
  }

  void bones()
  {
    const std::string path = Data("models/X/Testwuson.X");
    this->CompareAll(
      { "--animation", "Wuson_Walk", "--blend", "Wuson_Run=0.3", "--time", "0.4", path });
    this->CompareAll(
      { "--animation", "Wuson_Walk", "--blend", "Wuson_Run=0", "--time", "0.4", path });
    this->CompareAll({ "--bone-weight", "Spine_Back03", "--colormap", "rainbow", path });
    this->CompareAll({ "--color-by", "first_bone", "--scalar-bar", "--skin", "key-matrix", path });
  }

  void blocks()
  {
    this->CompareAll(
      { "--shadows", "map", "--light", "sun:0.4,1,0.6", this->WriteBlocks(false, false) });
    this->CompareAll(
      { "--color-by", "height", "--shadows", "exact", this->WriteBlocks(true, true) });
    const std::string waves = this->WriteImage();
    this->CompareAll(
      { "--normal-map", waves, "--shading", "flat", this->WriteBlocks(true, false) });
  }

  void holes()
  {
    this->CompareAll({ this->WriteHoled(true) });
    this->CompareAll({ "--color-by", "vtkOriginalCellIds", "--edges", this->WriteHoled(true) });
  }

  // Faces that change their material thousands of times, points and lines among them, faces of no
  // material, and names that are no words of Python.
  void mixedMaterials()
  {
    this->WriteImage();
    this->WriteText("mixed.mtl",
      "newmtl shining\nKd 0.8 0.3 0.2\nKs 1 1 1\nNs 12\nillum 2\n"
      "newmtl m\xf6rtel \"1\"\nKd 1 1 1\nmap_Kd waves.png\n");
    std::string mixed = "mtllib mixed.mtl\nv 0 -3 0\nv 60 -3 0\nv 60 -9 0\nl 1 2\nf 1 2 3\n"
                        "vt 0 0\nvt 1 0\nvt 0 1\n";
    for (int i = 0; i < 4200; ++i)
    {
      const std::string x = std::to_string(i % 60);
      const std::string y = std::to_string(i / 60);
      mixed += "v " + x + " " + y + " 0\nv " + x + ".9 " + y + " 0\nv " + x + " " + y +
        ".9 0\n\tusemtl " + (i % 2 == 0 ? "shining" : "m\xf6rtel \"1\" ") +
        "\r\n f -3/1\t-2/2 -1/3\n";
    }
    this->WriteText("mixed.obj", mixed + "p 1 3\n");
    this->CompareAll({ this->Path("mixed.obj") });
    this->CompareAll({ "--color-by", "vtkOriginalCellIds", this->Path("mixed.obj") });
  }

  // A line and a face that have a point which is not finite do not change the others' materials.
  // Before VTK 9.3 readers take the point before instead, which leaves nothing to see of the two.
  void holedMaterials()
  {
    this->WriteText("bright.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const std::string begin = "mtllib bright.mtl\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\n";
    const std::string faces = "usemtl red\nf 4 1 2\nusemtl blue\nf 4 2 3\n";
    this->WriteText("whole.obj", begin + faces);
    this->WriteText("holed.obj", begin + "v nan 0 0\nl 4 5\n" + faces + "usemtl red\nf 4 1 5\n");
    const std::vector<std::string> words = { "--camera", "0.5,0.5,5,0.5,0.5,0,0,1,0" };
    std::vector<vtkSmartPointer<vtkImageData>> shown;
    for (const char* file : { "whole.obj", "holed.obj" })
    {
      this->CompareAll({ words[0], words[1], this->Path(file) });
      shown.push_back(this->Grab());
    }
    QCOMPARE(CountDifferent(shown[0], shown[1]), 0);
  }
};

RELIEVO_TEST_CASE_APART(testViewerPythonFiles)
{
  TestViewerPythonFiles tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerPythonFiles.moc"
