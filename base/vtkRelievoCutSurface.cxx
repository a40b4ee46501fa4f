// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCutSurface.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"

//------------------------------------------------------------------------------
vtkInformationDoubleKey* vtkRelievoCutSurface::CUTOFF()
{
  static vtkInformationDoubleKey* const key =
    vtkInformationDoubleKey::MakeKey("CUTOFF", "vtkRelievoCutSurface");
  return key;
}

//------------------------------------------------------------------------------
double vtkRelievoCutSurface::GetCutoff(vtkInformation* keys)
{
  return keys && keys->Has(CUTOFF()) ? keys->Get(CUTOFF()) : 0.0;
}
