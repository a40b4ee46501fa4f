// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The smallest formats whose largest errors are within a tolerance
// (docs/choosing-formats.md).
#ifndef vtkRelievoFormatChoice_h
#define vtkRelievoFormatChoice_h

namespace vtkRelievoFormatChoice
{
// Whether a format meets the tolerance; 0 is valid and means no tolerance. Normals in degrees,
// depths as a share of the depth.
bool IsNormalTolerance(double degrees);
bool IsDepthTolerance(double share);

// The format for a valid tolerance above 0.
int ChooseNormal(double degrees);
int ChooseDepth(double share);
}

#endif
