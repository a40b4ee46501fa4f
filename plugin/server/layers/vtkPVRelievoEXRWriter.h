// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoEXRWriter
 * @brief vtkRelievoEXRWriter on several processes: the root writes, and all execute the pipeline.
 */
#ifndef vtkPVRelievoEXRWriter_h
#define vtkPVRelievoEXRWriter_h

#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoEXRWriter : public vtkRelievoEXRWriter
{
public:
  static vtkPVRelievoEXRWriter* New();
  vtkTypeMacro(vtkPVRelievoEXRWriter, vtkRelievoEXRWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPVRelievoEXRWriter() = default;
  ~vtkPVRelievoEXRWriter() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;

private:
  vtkPVRelievoEXRWriter(const vtkPVRelievoEXRWriter&) = delete;
  void operator=(const vtkPVRelievoEXRWriter&) = delete;
};

#endif
