// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOverlayBar.h"

#include "vtkRelievoAnnotation.h"
#include "vtkRelievoOverlayPen.h"

//------------------------------------------------------------------------------
vtkRelievoOverlayBar::vtkRelievoOverlayBar()
  : Pen(new vtkRelievoOverlayPen)
{
}

//------------------------------------------------------------------------------
vtkRelievoOverlayBar::~vtkRelievoOverlayBar() = default;

//------------------------------------------------------------------------------
void vtkRelievoOverlayBar::SetUnit(RELIEVO_TEXT unit)
{
  if (this->Unit != unit)
  {
    this->Unit = unit;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoOverlayBar::GetUnit()
{
  return this->Unit;
}

//------------------------------------------------------------------------------
double vtkRelievoOverlayBar::GetShownInk(vtkRenderer* renderer) const
{
  return this->Ink == INK_AUTOMATIC ? vtkRelievoAnnotation::GetInk(renderer)[0]
                                    : this->Ink == INK_WHITE;
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayBar::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Pen->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayBar::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Unit: " << this->Unit << "\n";
  os << indent << "TextSize: " << this->TextSize << "\n";
  os << indent << "Ink: " << this->Ink << "\n";
}
