// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The methods by number: vtkRelievoShadowStage::Methods.
#ifndef vtkRelievoShadowMethods_h
#define vtkRelievoShadowMethods_h

namespace vtkRelievoShadowMethods
{
enum Numbers
{
  MAP = 0,
  FORWARD = 1,
  WARPED = 2,
  EXACT = 3
};
}

#endif
