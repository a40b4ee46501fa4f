// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Blocks with colours and normals at the cells, which VTK's shaders look up by the numbers of
// primitives: blocks and cells are read right, or an error says that this VTK mixes the numbers up.
#include "Check.h"
#include "EmbreeScene.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Truth.h"
#include "View.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <string>

namespace testLayersBlocks
{
namespace
{
using relievoTest::EmbreeScene;
using relievoTest::Layers;
using relievoTest::MakeBox;
using relievoTest::Moved;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

enum class CellData
{
  Colors,
  Normals,
  Both
};

void TestCellData(CellData data)
{
  const Stage stage(240, 180);
  vtkNew<vtkMultiBlockDataSet> root;
  EmbreeScene scene;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto box = Moved(MakeBox(0.8, 0.8, 0.8), 1.2 * i - 1.2, 0.5, 0.);
    box->GetPointData()->SetNormals(nullptr);
    const vtkIdType count = box->GetNumberOfCells();
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (vtkIdType cell = 0; cell < count; ++cell)
    {
      normals->InsertNextTuple3(0., 0., 1.);
      colors->InsertNextTuple3(40. * cell, 80. * i, 200.);
    }
    if (data != CellData::Colors)
    {
      box->GetCellData()->SetNormals(normals);
    }
    if (data != CellData::Normals)
    {
      box->GetCellData()->SetScalars(colors);
    }
    root->SetBlock(i, box);
    scene.AddActor(box);
  }
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetInputDataObject(root);
  mapper->SetScalarModeToUseCellData();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const TruthImage truth = scene.Trace(View(stage.Renderer));
  bool told = true;
#ifdef RELIEVO_VTK_OVERLAPPING_BLOCKS
  told = data != CellData::Normals;
#endif
  const auto ask = [&](Way way) {
    long long mismatches = 0;
    long long seen = 0;
    const Layers layers(stage.Renderer, { "block", "cell" }, way);
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        if (pixel.Inner && pixel.Hit && pixel.EdgeDistance > 0.01)
        {
          mismatches += layers.Id("block", x, y) != (told ? pixel.Actor + 1 : -1) ||
              layers.Id("cell", x, y) != (told ? pixel.Cell : -1)
            ? 1
            : 0;
          ++seen;
        }
      }
    }
    RELIEVO_CHECK(seen > 1000);
    RELIEVO_CHECK_AT_MOST(mismatches, 0,
      "cell data " + std::to_string(static_cast<int>(data)) + ", " + relievoTest::ToString(way) +
        ": pixels with another block or cell");
  };
  for (const Way way : relievoTest::BothWays)
  {
    if (told)
    {
      ask(way);
      continue;
    }
    const relievoTest::ExpectMessage expected("same numbers");
    ask(way);
    RELIEVO_CHECK(expected.Count() == 1);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersBlocks)
{
  relievoTest::Session session;
  for (const CellData data : { CellData::Colors, CellData::Normals, CellData::Both })
  {
    TestCellData(data);
  }
  return session.Result();
}
}
