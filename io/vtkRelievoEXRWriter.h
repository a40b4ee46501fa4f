// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoEXRWriter_h
#define vtkRelievoEXRWriter_h

#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkObject.h"

class VTKRELIEVOIO_EXPORT vtkRelievoEXRWriter : public vtkObject
{
public:
  static vtkRelievoEXRWriter* New();
  vtkTypeMacro(vtkRelievoEXRWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkRelievoEXRWriter() = default;
  ~vtkRelievoEXRWriter() override = default;

private:
  vtkRelievoEXRWriter(const vtkRelievoEXRWriter&) = delete;
  void operator=(const vtkRelievoEXRWriter&) = delete;
};

#endif
