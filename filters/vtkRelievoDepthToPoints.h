// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoDepthToPoints_h
#define vtkRelievoDepthToPoints_h

#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKRELIEVOFILTERS_EXPORT vtkRelievoDepthToPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoDepthToPoints* New();
  vtkTypeMacro(vtkRelievoDepthToPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkRelievoDepthToPoints() = default;
  ~vtkRelievoDepthToPoints() override = default;

private:
  vtkRelievoDepthToPoints(const vtkRelievoDepthToPoints&) = delete;
  void operator=(const vtkRelievoDepthToPoints&) = delete;
};

#endif
