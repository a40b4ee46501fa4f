// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A scene that several processes hold in parts, for testShadowRanks.
#ifndef RankScene_h
#define RankScene_h

#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ShadowScenes.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkConeSource.h>
#include <vtkDataSetAttributes.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>

namespace relievoTest
{
inline constexpr int Width = 200;
inline constexpr int Height = 150;
inline constexpr int Pixels = Width * Height;
inline constexpr int Values = 6; // of a pixel: depth, two lights' visibility, colour

/** A process's part of the scene. All have all props, but the props of others have no mesh. */
struct RankScene
{
  ShadowStage Stage{ Width, Height };
  GLCheck Watch{ Stage.Window };
  vtkMultiProcessController* Controller;
  int Rank;
  int Ranks;
  vtkRelievoShadowStage* Shadows;
  vtkSmartPointer<vtkActor> Ground;
  vtkSmartPointer<vtkActor> Tall;
  vtkSmartPointer<vtkActor> Low;
  vtkSmartPointer<vtkActor> Ball; // a part on each
  vtkSmartPointer<vtkActor> Glyphs;
  std::vector<vtkSmartPointer<vtkActor>> Panes;
  vtkSmartPointer<vtkActor> Pair; // two panes side by side

  explicit RankScene(vtkMultiProcessController* controller)
    : Controller(controller)
    , Rank(controller->GetLocalProcessId())
    , Ranks(controller->GetNumberOfProcesses())
    , Shadows(Stage.GetShadows())
  {
    const int last = this->Ranks - 1; // of four, the third has nothing
    this->Ground = this->Stage.AddGround();
    this->Tall = this->Stage.AddBox({ 0.2, 0.83, -0.1 }, { 1.2, 1.6, 0.5 });
    this->Low = this->Stage.AddBox({ -1.4, 0.5, 0.9 }, { 0.9, 0.4, 0.7 });
    this->Tall->GetProperty()->SetColor(0.5, 0.8, 0.4);
    this->Keep(this->Ground, last);
    this->Keep(this->Tall, 0);
    this->Keep(this->Low, std::min(1, last));
    this->AddBall();
    this->AddGlyphs();
    for (int i = 0; i < 2; ++i)
    {
      const double x = -3.4 + 0.9 * i;
      const auto mesh = MakePolygons({ { x, 4. + i, -3. }, { x + 1.7, 4. + i, -3. },
        { x + 1.7, 4. + i, -1.4 }, { x, 4. + i, -1.4 } });
      mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
      this->AddPane(mesh, i == 0 ? 0 : last);
      this->Panes.back()->GetProperty()->SetOpacity(i == 0 ? 0.3 : 0.5);
      this->Panes.back()->GetProperty()->SetColor(1. - 0.8 * i, 0.4, 0.2 + 0.7 * i);
    }
    this->AddPair(last);
    this->Stage.AddSun(-3., 4., -2.);
    this->Stage.AddLamp({ 1.5, 3., 1.5 }, { 0., 0., 0. }, 90.);
    this->Shadows->SetMethodToExact();
    this->Shadows->SetController(controller);
    this->Stage.GetFrame()->ShadowsOn();
  }

  ~RankScene() { this->Shadows->SetController(nullptr); }

  static vtkPolyData* GetMesh(vtkActor* actor)
  {
    return vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
  }

  void Keep(vtkActor* actor, int owner) const
  {
    if (owner != this->Rank)
    {
      vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(vtkNew<vtkPolyData>());
    }
  }

  // All points, and every so many-th cell.
  void AddBall()
  {
    const auto whole = Moved(MakeBall(0.5), 1.6, 0.6, 0.8);
    vtkNew<vtkCellArray> own;
    auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(whole->GetPolys()->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      if (it->GetCurrentCellId() % this->Ranks == this->Rank)
      {
        own->InsertNextCell(it->GetCurrentCell());
      }
    }
    whole->SetPolys(own);
    this->Ball = AddActor(this->Stage.Renderer, whole);
    this->Ball->VisibilityOff();
  }

  void AddGlyphs()
  {
    vtkNew<vtkPoints> places;
    for (int i = 0; i < 12 && this->Rank == 0; ++i)
    {
      places->InsertNextPoint(-2.5 + 0.45 * i, 1.3 + 0.1 * (i % 3), 2. - 0.3 * (i % 4));
    }
    vtkNew<vtkPolyData> points;
    points->SetPoints(places);
    vtkNew<vtkConeSource> cone;
    cone->SetHeight(0.5);
    cone->SetRadius(0.15);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(points);
    mapper->SetSourceConnection(cone->GetOutputPort());
    mapper->ScalingOff();
    this->Glyphs = vtkSmartPointer<vtkActor>::New();
    this->Glyphs->SetMapper(mapper);
    this->Glyphs->VisibilityOff();
    this->Stage.Renderer->AddActor(this->Glyphs);
  }

  void AddPane(vtkPolyData* mesh, int owner)
  {
    this->Panes.push_back(AddActor(this->Stage.Renderer, mesh));
    this->Keep(this->Panes.back(), owner);
    this->Panes.back()->VisibilityOff();
    this->Shadows->SetPropCasts(this->Panes.back(), vtkRelievoShadowStage::CASTS_ALWAYS);
  }

  // The first and the last process have one each, and a copy of the other's.
  void AddPair(int last)
  {
    const auto mesh = MakePolygons({ { -1.9, 4., -0.6 }, { -1.2, 4., -0.6 }, { -0.5, 4., -0.6 },
      { -1.9, 4., 0.6 }, { -1.2, 4., 0.6 }, { -0.5, 4., 0.6 } });
    mesh->GetPolys()->InsertNextCell({ 0, 1, 4, 3 });
    mesh->GetPolys()->InsertNextCell({ 1, 2, 5, 4 });
    if (last > 0)
    {
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      const unsigned char copy = vtkDataSetAttributes::DUPLICATECELL;
      ghosts->InsertNextValue(this->Rank == 0 ? 0 : copy);
      ghosts->InsertNextValue(this->Rank == 0 ? copy : 0);
      mesh->GetCellData()->AddArray(ghosts);
    }
    this->AddPane(mesh, this->Rank == last ? last : 0);
    this->Pair = this->Panes.back();
    this->Pair->GetProperty()->SetOpacity(0.5);
  }

  // Appends the picture, and layers of another frame.
  void Record(std::vector<float>& numbers)
  {
    const auto picture = Picture(this->Stage.Window);
    const Layers layers(this->Stage.Renderer, { "depth", "shadow_0", "shadow_1" });
    for (int i = 0; i < Pixels; ++i)
    {
      for (const char* name : { "depth", "shadow_0", "shadow_1" })
      {
        numbers.push_back(static_cast<float>(layers.Value(name, i % Width, i / Width)));
      }
      for (int channel = 0; channel < 3; ++channel)
      {
        numbers.push_back(
          static_cast<float>(picture->GetPointData()->GetScalars()->GetComponent(i, channel)));
      }
    }
  }
};

}

#endif
