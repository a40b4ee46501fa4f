// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SkinFrames.h"

#include "FrameBench.h"
#include "Window.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkRelievoSkin.h"
#include "vtkRelievoSkinnedActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace relievoBench
{
namespace
{
constexpr int Width = 640, Height = 480;

// One method of drawing, in its own window.
struct SkinWindow
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkRelievoSkinnedActor> Skinned; // null: rigid
  int Frames = 0;

  // A method of vtkRelievoSkin; -1: rigid.
  SkinWindow(vtkPolyData* mesh, vtkPolyData* pose, int method)
    : Window(relievoTest::MakeWindow(Width, Height, this->Renderer))
  {
    if (method < 0)
    {
      this->Mapper->SetInputData(mesh);
      this->Actor = vtkSmartPointer<vtkActor>::New();
      this->Actor->SetMapper(this->Mapper);
    }
    else
    {
      this->Skinned = vtkSmartPointer<vtkRelievoSkinnedActor>::New();
      this->Skinned->SetInputData(mesh);
      this->Skinned->SetSkeletonData(pose);
      this->Skinned->SetMethod(method);
      this->Actor = this->Skinned;
    }
    this->Renderer->AddActor(this->Actor);
    this->Renderer->ResetCamera(mesh->GetBounds());
  }
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSheet(int points)
{
  const int side = std::max(2, static_cast<int>(std::sqrt(points)));
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> places;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < side * side; ++i)
  {
    const double x = 2. * (i % side) / (side - 1.) - 1.;
    const double y = 2. * (i / side) / (side - 1.) - 1.;
    places->InsertNextPoint(x, y, 0.05 * std::sin(9. * x));
    const double slope = 0.45 * std::cos(9. * x);
    const double length = std::hypot(slope, 1.);
    normals->InsertNextTuple3(-slope / length, 0., 1. / length);
    if (i % side > 0 && i >= side)
    {
      const vtkIdType corners[2][3] = { { i - side - 1, i - side, i }, { i - side - 1, i, i - 1 } };
      triangles->InsertNextCell(3, corners[0]);
      triangles->InsertNextCell(3, corners[1]);
    }
  }
  sheet->SetPoints(places);
  sheet->SetPolys(triangles);
  sheet->GetPointData()->SetNormals(normals);
  return sheet;
}

//------------------------------------------------------------------------------
std::vector<std::vector<double>> TimeSkinnedFrames(
  vtkPolyData* mesh, vtkPolyData* pose, vtkPolyData* otherPose, int rounds)
{
  SkinWindow rigid(mesh, pose, -1);
  SkinWindow linear(mesh, pose, vtkRelievoSkin::LINEAR);
  SkinWindow dual(mesh, pose, vtkRelievoSkin::DUAL_QUATERNION);
  std::vector<relievoTest::Timed> ways;
  for (SkinWindow* each : { &rigid, &linear, &dual })
  {
    const relievoTest::Timed frame = relievoTest::Frame(each->Window);
    relievoTest::Timed way = frame;
    way.Work = [each, frame, pose, otherPose]() {
      if (each->Skinned)
      {
        each->Skinned->SetSkeletonData(++each->Frames % 2 ? otherPose : pose);
      }
      frame.Work();
    };
    ways.push_back(way);
  }
  std::vector<std::vector<double>> seconds;
  for (relievoTest::Timing& timing : TimeInTurn(ways, rounds))
  {
    std::sort(timing.Seconds.begin(), timing.Seconds.end());
    seconds.push_back(timing.Seconds);
  }
  return seconds;
}
}
