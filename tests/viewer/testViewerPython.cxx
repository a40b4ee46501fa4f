// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture of the Python program that the window copies equals the window's, byte for byte.
#include "TestCase.h"
#include "ViewerTest.h"

#include <QtTest>

namespace testViewerPython
{
class TestViewerPython : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  void CompareProgram(std::vector<std::string> words)
  {
    words.push_back(this->WriteScene());
    this->Open(words);
    const vtkSmartPointer<vtkImageData> shown = this->Grab();
    QCOMPARE(CountDifferent(shown, this->RunPython()), 0);
  }

private Q_SLOTS:
  void plain() { this->CompareProgram({}); }

  void shadowsAndTone()
  {
    this->CompareProgram({ "--light", "sun:0.4,1,0.6", "--light", "point:2,2,2", "--shadows",
      "exact", "--tone", "reinhard,white=2", "--camera", "2,2,4,0,0.5,0,0,1,0" });
  }

  void look()
  {
    this->CompareProgram({ "--color-by", "height", "--colormap", "rainbow", "--edges", "--opacity",
      "0.6", "--background", "white,#8899aa", "--shading", "flat", "--parallel-scale", "1.5" });
  }

  // Also the material's highlights.
  void oneMaterial()
  {
    this->Open(
      { this->WriteOBJ(false), "--light", "sun:0.2,0.1,1", "--camera", "1,1,5,1,1,0,0,1,0" });
    const vtkSmartPointer<vtkImageData> shown = this->Grab();
    QCOMPARE(CountDifferent(shown, this->RunPython()), 0);
  }

  void files()
  {
    const std::string data = qgetenv("RELIEVO_DATA").toStdString();
    this->CompareProgram({ "--time", "1.5", "--skin", "dual-quaternion", "--skeleton",
      data + "/models/glTF2/simple_skin/simple_skin.gltf",
      data + "/textured/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb" });
  }

  void points()
  {
    const std::string file = this->WritePoints();
    this->CompareProgram({ "--lamps", file + ",intensity=2,color=1/0.6/0.3", "--fog",
      file + ",density=0.8,mode=chord", "--markers", file + ",shape=disc,radius=0.4" });
    this->CompareProgram({ "--markers", file + ",shape=shadow,radius=0.5,color=0/0/0", "--lamps",
      file + ",falloff=inverse-square,casts=always", "--up", "z" });
  }

  void surfaces()
  {
    const std::string picture = this->WriteImage();
    this->CompareProgram({ "--environment", picture + ",30", "--reflectivity", "0.4,0.3" });
    this->CompareProgram(
      { "--environment", picture, "--skybox", "--shadows", "map", "--light", "sun:0.4,1,0.6" });
    this->CompareProgram({ "--normal-map", picture, "--texture-coordinates", "sphere" });
    this->CompareProgram({ "--height-map", picture + ",0.1", "--shadows", "map", "--light",
      "sun:0.4,1,0.6", "--environment", picture });
  }

  void colorScale()
  {
    this->CompareProgram({ "--color-by", "height", "--scalar-bar", "--background", "white" });
  }

  void coloredShadows()
  {
    this->CompareProgram({ "--color", "#3366cc", "--opacity", "0.5", "--shadows", "exact",
      "--colored-shadows", "--light", "sun:0.4,1,0.6" });
  }
};

RELIEVO_TEST_CASE_APART(testViewerPython)
{
  TestViewerPython tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerPython.moc"
