// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoEXRReader_h
#define vtkRelievoEXRReader_h

#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

class VTKRELIEVOIO_EXPORT vtkRelievoEXRReader : public vtkImageAlgorithm
{
public:
  static vtkRelievoEXRReader* New();
  vtkTypeMacro(vtkRelievoEXRReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkRelievoEXRReader() = default;
  ~vtkRelievoEXRReader() override = default;

private:
  vtkRelievoEXRReader(const vtkRelievoEXRReader&) = delete;
  void operator=(const vtkRelievoEXRReader&) = delete;
};

#endif
