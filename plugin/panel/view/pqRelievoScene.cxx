// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoScene.h"

#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqRelievoViewSettings.h"
#include "pqServer.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRelievoUpOfView.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr double Reach = 2.0; // half the ground's width, in radii of the scene
constexpr double GreyOfGround = 0.45;
constexpr double Flat = 0.25; // largest height over width of a surface that shows shadows

// A vector property of a representation; keeps the given values if it is missing.
void Read(vtkSMProxy* representation, const char* name, double values[3])
{
  if (representation->GetProperty(name))
  {
    vtkSMPropertyHelper(representation, name).Get(values, 3);
  }
}

vtkBoundingBox GetBox(pqDataRepresentation* shown)
{
  vtkBoundingBox box;
  vtkPVDataInformation* about = shown->getInputDataInformation();
  double bounds[6];
  if (!about)
  {
    return box;
  }
  about->GetBounds(bounds);
  if (!vtkBoundingBox::IsValid(bounds))
  {
    return box;
  }
  vtkSMProxy* proxy = shown->getProxy();
  double place[3] = { 0.0, 0.0, 0.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  double angles[3] = { 0.0, 0.0, 0.0 };
  double scale[3] = { 1.0, 1.0, 1.0 };
  Read(proxy, "Position", place);
  Read(proxy, "Translation", place); // since ParaView 5.13
  Read(proxy, "Origin", origin);
  Read(proxy, "Orientation", angles);
  Read(proxy, "Scale", scale);
  vtkNew<vtkTransform> moved;
  moved->Translate(origin[0] + place[0], origin[1] + place[1], origin[2] + place[2]);
  moved->RotateZ(angles[2]);
  moved->RotateX(angles[0]);
  moved->RotateY(angles[1]);
  moved->Scale(scale);
  moved->Translate(-origin[0], -origin[1], -origin[2]);
  for (int corner = 0; corner < 8; ++corner)
  {
    const double point[3] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + ((corner >> 2) & 1)] };
    box.AddPoint(moved->TransformDoublePoint(point));
  }
  return box;
}

// The sun's up axis if it is on, or once the user has chosen it.
int GetUpAxis(pqView* view)
{
  const int given = std::clamp(pqRelievoViewSettings::Get(view, "RelievoSunUpAxis").toInt(), 0, 2);
  return pqRelievoViewSettings::IsSunOn(view) || given != 2 ? given
                                                            : pqRelievoScene::FindUpAxis(view);
}
}

//------------------------------------------------------------------------------
QVector<pqDataRepresentation*> pqRelievoScene::FindSurfaces(pqView* view)
{
  static const QVector<QString> kinds = { "Surface", "Surface With Edges", "Wireframe", "Points",
    "3D Glyphs", "Feature Edges" };
  QVector<pqDataRepresentation*> found;
  for (pqRepresentation* each : view ? view->getRepresentations() : QList<pqRepresentation*>())
  {
    auto* shown = qobject_cast<pqDataRepresentation*>(each);
    if (!shown || !shown->isVisible() || !shown->getProxy()->GetProperty("RelievoMaterial"))
    {
      continue;
    }
    vtkSMProperty* kind = shown->getProxy()->GetProperty("Representation");
    if (!kind || kinds.contains(vtkSMPropertyHelper(kind).GetAsString()))
    {
      found.append(shown);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
bool pqRelievoScene::IsUsed(pqView* view, const QString& name)
{
  const QList<pqRepresentation*> all =
    view ? view->getRepresentations() : QList<pqRepresentation*>();
  return std::any_of(all.begin(), all.end(), [&name](pqRepresentation* each) {
    vtkSMProperty* on = each->getProxy()->GetProperty(qUtf8Printable(name));
    return on && each->isVisible() && vtkSMPropertyHelper(on).GetAsInt() != 0;
  });
}

//------------------------------------------------------------------------------
bool pqRelievoScene::GetBounds(pqView* view, double bounds[6])
{
  vtkBoundingBox all;
  for (pqDataRepresentation* each : FindSurfaces(view))
  {
    all.AddBox(GetBox(each));
  }
  all.GetBounds(bounds);
  return all.IsValid() != 0;
}

//------------------------------------------------------------------------------
int pqRelievoScene::FindUpAxis(pqView* view)
{
  double bounds[6];
  return GetBounds(view, bounds) ? vtkSMRelievoUpOfView::FindUpAxis(view->getProxy(), bounds) : 2;
}

//------------------------------------------------------------------------------
bool pqRelievoScene::HasGround(pqView* view)
{
  const int up = GetUpAxis(view);
  const QVector<pqDataRepresentation*> surfaces = FindSurfaces(view);
  return std::any_of(surfaces.begin(), surfaces.end(), [up](pqDataRepresentation* each) {
    const vtkBoundingBox box = GetBox(each);
    const double width =
      box.IsValid() ? std::max(box.GetLength((up + 1) % 3), box.GetLength((up + 2) % 3)) : 0.0;
    return width > 0.0 && box.GetLength(up) <= Flat * width;
  });
}

//------------------------------------------------------------------------------
void pqRelievoScene::MakeGround(pqView* view)
{
  double bounds[6];
  if (!GetBounds(view, bounds))
  {
    return;
  }
  const vtkBoundingBox box(bounds);
  const double radius = 0.5 * box.GetDiagonalLength();
  const int up = GetUpAxis(view);
  const int first = (up + 1) % 3; // first x second = up
  const int second = (up + 2) % 3;
  double corners[3][3]; // the origin, and the ends of both edges
  for (double* corner : corners)
  {
    box.GetCenter(corner);
    corner[up] = bounds[2 * up] - 1e-4 * radius; // avoids z-fighting with flat bottoms
    corner[first] -= Reach * radius;
    corner[second] -= Reach * radius;
  }
  corners[1][first] += 2.0 * Reach * radius;
  corners[2][second] += 2.0 * Reach * radius;

  SCOPED_UNDO_SET("Ground plane");
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  const auto plane = vtk::TakeSmartPointer(vtkSMSourceProxy::SafeDownCast(
    view->getServer()->proxyManager()->NewProxy("sources", "PlaneSource")));
  if (!plane)
  {
    return;
  }
  controller->PreInitializeProxy(plane);
  const char* names[3] = { "Origin", "Point1", "Point2" };
  for (int i = 0; i < 3; ++i)
  {
    vtkSMPropertyHelper(plane, names[i]).Set(corners[i], 3);
  }
  controller->PostInitializeProxy(plane);
  controller->RegisterPipelineProxy(plane, "Ground");
  vtkSMProxy* shown = controller->Show(plane, 0, view->getViewProxy());
  vtkSMProperty* ink = view->getProxy()->GetProperty("OrientationAxesLabelColor");
  if (shown && shown->GetProperty("DiffuseColor") && ink &&
    vtkSMPropertyHelper(ink).GetAsDouble(0) > 0.5)
  {
    // White annotations in front of it would be unreadable, as on the view's own background.
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", shown);
    const std::vector<double> color(3, GreyOfGround);
    for (const char* name : { "AmbientColor", "DiffuseColor" })
    {
      vtkSMPropertyHelper(shown, name).Set(color.data(), 3);
    }
    shown->UpdateVTKObjects();
  }
  view->render();
}

//------------------------------------------------------------------------------
bool pqRelievoScene::IsLitByEnvironment(pqView* view)
{
  const QVector<pqDataRepresentation*> surfaces = FindSurfaces(view);
  return !surfaces.isEmpty() &&
    std::all_of(surfaces.begin(), surfaces.end(), [](pqDataRepresentation* each) {
      return vtkSMPropertyHelper(each->getProxy(), "RelievoMaterial").GetAsInt() != 0 &&
        vtkSMPropertyHelper(each->getProxy(), "RelievoMirror").GetAsInt() != 0;
    });
}

//------------------------------------------------------------------------------
void pqRelievoScene::LightByEnvironment(pqView* view)
{
  {
    SCOPED_UNDO_SET("Light all surfaces with the environment");
    for (pqDataRepresentation* each : FindSurfaces(view))
    {
      SM_SCOPED_TRACE(PropertiesModified).arg("proxy", each->getProxy());
      vtkSMPropertyHelper(each->getProxy(), "RelievoMaterial").Set(1);
      vtkSMPropertyHelper(each->getProxy(), "RelievoMirror").Set(1);
      each->getProxy()->UpdateVTKObjects();
    }
  }
  view->render();
}
