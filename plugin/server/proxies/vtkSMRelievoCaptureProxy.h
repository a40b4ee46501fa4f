// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoCaptureProxy
 * @brief Takes the layers of a view's picture, wherever that is drawn.
 *
 * Drives vtkPVRelievoCapture on the client and the servers: a picture is drawn as the view always
 * draws it, its layers are read where the geometry was, and the image moves to where it is wanted.
 * Every step is started from here on all processes that take part, so none waits for another that
 * does not come.
 */
#ifndef vtkSMRelievoCaptureProxy_h
#define vtkSMRelievoCaptureProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMProxy.h"

#include <string> // for names
#include <vector> // for names

class vtkImageData;
class vtkSMProperty;
class vtkSMViewProxy;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoCaptureProxy : public vtkSMProxy
{
public:
  static vtkSMRelievoCaptureProxy* New();
  vtkTypeMacro(vtkSMRelievoCaptureProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Destinations
  {
    TO_SERVER = 0, // the root of the data servers
    TO_CLIENT = 1
  };

  /**
   * Draws the view and takes its layers. Returns false, with an error, if the view cannot be drawn;
   * layers that cannot be read are reported where that happens, unless `quiet`.
   */
  bool Capture(
    vtkSMViewProxy* view, const std::vector<std::string>& layers, int destination, bool quiet);

  ///@{
  /** Takes the layers of a picture that is drawn anyway: Start() before it, Finish() after it. */
  void Start(vtkSMViewProxy* view, const std::vector<std::string>& layers);
  void Finish(int destination, bool quiet);
  ///@}

  /** Names whose status is on, of a property of names and statuses. */
  static std::vector<std::string> GetSelected(vtkSMProperty* property);

  /** The client's image: that of TO_CLIENT, and without a server every image. */
  vtkImageData* GetImage();

protected:
  vtkSMRelievoCaptureProxy();
  ~vtkSMRelievoCaptureProxy() override;

private:
  vtkSMRelievoCaptureProxy(const vtkSMRelievoCaptureProxy&) = delete;
  void operator=(const vtkSMRelievoCaptureProxy&) = delete;

  void Call(const char* method, vtkTypeUInt32 where);
  void OnDrawn();

  vtkSMViewProxy* View = nullptr; // between Start() and Finish()
  bool Drawn = false;             // StillRender() did
  bool Color = false;             // is among its layers
  bool Others = false;            // there are others
};

#endif
