// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files with decimal points, where the user's locale has commas.
#include "TestCase.h"
#include "ViewerTest.h"

#include "vtkRenderer.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>

namespace testViewerLocale
{
class TestViewerLocale : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  // The command reads the file in this locale, too: the truth are the bounds, that of z up to its
  // sign.
  void Check(const std::string& name, const std::string& text,
    const std::array<double, 4>& bounds = { 0.25, 1.75, 0.25, 1.75 })
  {
    this->WriteText(name, text);
    this->Window ? this->OpenAgain({ this->Path(name) }) : this->Open({ this->Path(name) });
    this->Compare(name.c_str());
    double found[6];
    this->Window->GetView()->GetPicture().GetRenderer()->ComputeVisiblePropBounds(found);
    for (int i = 0; i < 4; ++i)
    {
      QVERIFY2(std::abs(found[i] - bounds[i]) < 1e-6, name.c_str());
    }
    QVERIFY2(std::abs(std::abs(found[4]) - 0.5) < 1e-6 && found[4] == found[5], name.c_str());
  }

private Q_SLOTS:
  // Qt's own texts, and the names of files, stay as the user wants them.
  void localeOfNumbers()
  {
    QCOMPARE(QString(std::setlocale(LC_NUMERIC, nullptr)), QString("C"));
    QCOMPARE(QString(std::setlocale(LC_CTYPE, nullptr)), qEnvironmentVariable("LC_ALL"));
  }

  // A triangle whose corners all have places after the point.
  void meshes()
  {
    this->Check("a.stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0.25 0.25 0.5\nvertex 1.75 0.5 0.5\n"
      "vertex 0.5 1.75 0.5\nendloop\nendfacet\nendsolid a\n");
    this->Check("a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0.25 0.25 0.5\n1.75 0.5 0.5\n0.5 1.75 0.5\n3 0 1 2\n");
    this->Check("a.obj", "v 0.25 0.25 0.5\nv 1.75 0.5 0.5\nv 0.5 1.75 0.5\nf 1 2 3\n");
    this->Check("a.off", "OFF\n3 1 0\n0.25 0.25 0.5\n1.75 0.5 0.5\n0.5 1.75 0.5\n3 0 1 2\n");
    this->Check("a.vtk",
      "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0.25 0.25 0.5\n"
      "1.75 0.5 0.5\n0.5 1.75 0.5\nPOLYGONS 1 4\n3 0 1 2\n");
    this->Check("A.VTI",
      "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 1 0 1 0 0\" Origin=\"0.5 0.25 0.5\" "
      "Spacing=\"0.5 0.75 0.5\"><Piece Extent=\"0 1 0 1 0 0\"><PointData Scalars=\"h\"><DataArray "
      "type=\"Float32\" Name=\"h\" format=\"ascii\">0.5 1.5 2.5 3.5</DataArray></PointData>"
      "</Piece></ImageData></VTKFile>",
      { 0.5, 1.0, 0.25, 1.0 });
    this->Check("a.dae.x",
      "xof 0303txt 0032\nMesh a {\n3;\n0.25;0.25;0.5;,\n1.75;0.5;0.5;,\n0.5;1.75;0.5;;\n1;\n"
      "3;0,1,2;;\n}\n");
  }

  void lampsAndValues()
  {
    this->WriteText("lamps.vtk",
      "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0.25 0.5 1.5\n"
      "POINT_DATA 1\nSCALARS radius float 1\nLOOKUP_TABLE default\n2.5\n");
    this->Open({ this->WriteScene(), "--lamps", this->Path("lamps.vtk") + ",intensity=0.75" });
    this->Compare("lamps");
    const vtkSmartPointer<vtkImageData> lit = this->Grab();
    this->Change(
      [](scene::Settings& settings) { settings.SetParameter("tone", "exposure", "1.5"); });
    this->Compare("a value that was set");
    QVERIFY(CountDifferent(lit, this->Grab()) > 100);
  }
};

RELIEVO_TEST_CASE_APART(testViewerLocale)
{
  if (!qEnvironmentVariableIsSet("LOCPATH"))
  {
    // In each locale a process. They are made here: a system has those that its users asked for.
    int status = 0;
    for (const QString name : { "de_DE", "tr_TR" })
    {
      const QTemporaryDir folder;
      qputenv("LOCPATH", folder.path().toLocal8Bit());
      qputenv("LC_ALL", name.toLatin1() + ".UTF-8");
      const QString made = folder.filePath(name + ".UTF-8");
      if (QProcess::execute("localedef", { "-i", name, "-f", "UTF-8", made }) != 0)
      {
        std::fputs("localedef makes no such locale; install the package locales\n", stderr);
        return 1;
      }
      status |= QProcess::execute("/proc/self/exe", { "--case", "testViewerLocale" });
    }
    return status;
  }
  TestViewerLocale tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerLocale.moc"
