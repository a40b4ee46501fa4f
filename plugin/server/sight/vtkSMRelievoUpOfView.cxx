// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoUpOfView.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMOutputPort.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSMRelievoUpOfView);

namespace
{
// Largest height of a flat mesh, as a share of both its width and its length.
constexpr double LowShare = 0.34;

bool IsLow(const double bounds[6], int axis)
{
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return false;
  }
  const auto extent = [bounds](int i) { return bounds[2 * i + 1] - bounds[2 * i]; };
  return extent(axis) < LowShare * std::min(extent((axis + 1) % 3), extent((axis + 2) % 3));
}
}

//------------------------------------------------------------------------------
int vtkSMRelievoUpOfView::FindUpAxis(vtkSMProxy* view, const double bounds[6])
{
  for (const int axis : { 1, 2 })
  {
    if (IsLow(bounds, axis)) // even seen from above, with another axis up in the picture
    {
      return axis;
    }
  }
  auto* renderView = vtkSMRenderViewProxy::SafeDownCast(view);
  vtkCamera* camera = renderView ? renderView->GetActiveCamera() : nullptr;
  if (!camera)
  {
    return 2;
  }
  const double* up = camera->GetViewUp();
  const auto nearest =
    std::max_element(up, up + 3, [](double a, double b) { return std::abs(a) < std::abs(b); });
  return static_cast<int>(nearest - up);
}

//------------------------------------------------------------------------------
void vtkSMRelievoUpOfView::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  vtkSMOutputPort* input = vtkSMPropertyHelper(proxy, "Input", true).GetAsOutputPort();
  vtkSMProperty* axis = proxy->GetProperty("UpAxis");
  if (!input || !axis || axis->GetMTime() > initializationTimeStamp)
  {
    return;
  }
  input->GetSourceProxy()->UpdatePipeline(); // computes the bounds
  vtkSMProxySelectionModel* views =
    proxy->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  vtkSMPropertyHelper(axis).Set(FindUpAxis(
    views ? views->GetCurrentProxy() : nullptr, input->GetDataInformation()->GetBounds()));
  proxy->UpdateVTKObjects();
}
