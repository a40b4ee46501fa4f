// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoEXRExporterProxy
 * @brief File > Export View: the view's picture and layers into one OpenEXR file.
 *
 * The layers are read where the picture is drawn; only pixels are sent to the client, which writes
 * the file (vtkRelievoEXRWriter).
 */
#ifndef vtkSMRelievoEXRExporterProxy_h
#define vtkSMRelievoEXRExporterProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMRenderViewExporterProxy.h"

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoEXRExporterProxy
  : public vtkSMRenderViewExporterProxy
{
public:
  static vtkSMRelievoEXRExporterProxy* New();
  vtkTypeMacro(vtkSMRelievoEXRExporterProxy, vtkSMRenderViewExporterProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Draws the view and writes the file. After an error no file is left or changed. */
  void Write() override;

protected:
  vtkSMRelievoEXRExporterProxy() = default;
  ~vtkSMRelievoEXRExporterProxy() override = default;

private:
  vtkSMRelievoEXRExporterProxy(const vtkSMRelievoEXRExporterProxy&) = delete;
  void operator=(const vtkSMRelievoEXRExporterProxy&) = delete;
};

#endif
