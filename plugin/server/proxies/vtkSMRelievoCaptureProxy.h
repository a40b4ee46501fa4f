// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoCaptureProxy
 * @brief Reads the layers of a view's picture, on whichever process draws it.
 *
 * Drives vtkPVRelievoCapture on the client and the servers: the view draws a picture as usual, its
 * layers are read where the geometry was drawn, and the image moves to its destination. Every step
 * is started from here on all participating processes, so that none waits for another in vain.
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
   * Draws the view and reads its layers. Returns false, with an error, if the view cannot be drawn;
   * unreadable layers are reported where they occur, unless `quiet`.
   */
  bool Capture(
    vtkSMViewProxy* view, const std::vector<std::string>& layers, int destination, bool quiet);

  ///@{
  /**
   * Reads the layers of a picture drawn for another purpose: Start() before it, Finish() after it.
   */
  void Start(vtkSMViewProxy* view, const std::vector<std::string>& layers);
  void Finish(int destination, bool quiet);
  ///@}

  /** Names with status on, in a property of names and statuses. */
  static std::vector<std::string> GetSelected(vtkSMProperty* property);

  /** The client's image: the one for TO_CLIENT, and without a server every image. */
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
  bool Drawn = false;             // whether StillRender() has drawn
  bool Color = false;             // whether color is requested
  bool Others = false;            // whether other layers are requested
};

#endif
