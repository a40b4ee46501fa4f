// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Materials of files, models at a time and fog equal the command line's, also after a change.
#include "TestCase.h"
#include "ViewerTest.h"

#include <QtTest>

namespace testViewerScenes
{
using scene::Settings;

class TestViewerScenes : public viewerTest::ViewerTest
{
  Q_OBJECT

private Q_SLOTS:
  // The values of fog stay when other stages come and go.
  void fogModeStays()
  {
    const std::string fog = this->WritePoints() + ",density=0.8,mode=";
    this->Open({ this->WriteScene(), "--fog", fog + "beer" });
    const vtkSmartPointer<vtkImageData> beer = this->Grab();
    this->Open({ this->WriteScene(), "--fog", fog + "chord" });
    const vtkSmartPointer<vtkImageData> chord = this->Grab();
    QVERIFY(CountDifferent(beer, chord) > 100);
    this->Change([](scene::Settings& settings) { settings.SetParameter("tone", "exposure", "1"); });
    this->Compare("fog and tone");
    this->Change([](scene::Settings& settings) { settings.AskStage("tone", false); });
    QCOMPARE(CountDifferent(this->Grab(), chord), 0);
    this->Change([](scene::Settings& settings) { settings.SetParameter("fog", "mode", "beer"); });
    QCOMPARE(CountDifferent(this->Grab(), beer), 0);
  }

  void materialsOfOBJ()
  {
    this->Open({ this->WriteOBJ(), "--light", "sun:0.2,0.1,1", "--shadows", "map" });
    this->Compare("materials");
    const vtkSmartPointer<vtkImageData> styled = this->Grab();
    this->Change([](scene::Settings& settings) { settings.Set("--color", "#336699"); });
    this->Compare("a colour instead");
    QVERIFY(CountDifferent(styled, this->Grab()) > 100);
    this->Change([](scene::Settings& settings) { settings.Remove("--color"); });
    QCOMPARE(CountDifferent(styled, this->Grab()), 0);
  }

  void glTF()
  {
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/glTF2/";
    this->Open({ models + "simple_skin/simple_skin.gltf" });
    this->Compare("as it lies");
    this->Change([](scene::Settings& settings) { settings.Set("--time", "0"); });
    this->Compare("at its first time");
    const vtkSmartPointer<vtkImageData> rest = this->Grab();
    this->Change([](scene::Settings& settings) { settings.Set("--time", "1.5"); });
    this->Compare("at a time");
    QVERIFY(CountDifferent(rest, this->Grab()) > 100);
    this->Change([](scene::Settings& settings) { settings.Set("--skeleton", ""); });
    this->Compare("with its bones");
  }

  // Wide lines take the same pixels, at their ends too.
  void bones()
  {
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/";
    for (const char* name : { "BVH/01_01.bvh", "X/Testwuson.X", "MS3D/Wuson.ms3d" })
    {
      this->Open({ models + name, "--skeleton" });
      this->Compare(name);
    }
  }
};

RELIEVO_TEST_CASE_APART(testViewerScenes)
{
  TestViewerScenes tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerScenes.moc"
