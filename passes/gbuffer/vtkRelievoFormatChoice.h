// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The smallest formats of vtkRelievoLayersStage whose largest errors are within a tolerance
// (docs/choosing-formats.md).
#ifndef vtkRelievoFormatChoice_h
#define vtkRelievoFormatChoice_h

namespace vtkRelievoFormatChoice
{
// Whether a format keeps the tolerance, or 0 says that none is chosen: normals in degrees, depths
// as a share of the depth.
bool IsNormalTolerance(double degrees);
bool IsDepthTolerance(double share);

// The format for such a tolerance above 0.
int ChooseNormal(double degrees);
int ChooseDepth(double share);
}

#endif
