// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoLayersProxy
 * @brief Proxy of the source "Relievo Layers": grabs a view's layers when that is due.
 *
 * It is due when a property that says what to grab is set, at the command GrabAgain, with
 * FollowView after each picture of the view at full quality, and after the first picture of a view
 * that had none when the layers were asked for (a state file's, whose scene is not yet there). In
 * between the layers stay as they are.
 */
#ifndef vtkSMRelievoLayersProxy_h
#define vtkSMRelievoLayersProxy_h

#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h" // for the view

class vtkSMRelievoCaptureProxy;
class vtkSMViewProxy;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkSMRelievoLayersProxy : public vtkSMSourceProxy
{
public:
  static vtkSMRelievoLayersProxy* New();
  vtkTypeMacro(vtkSMRelievoLayersProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;
  void UpdatePipeline() override;
  void UpdatePipeline(double time) override;

protected:
  vtkSMRelievoLayersProxy();
  ~vtkSMRelievoLayersProxy() override;

  ///@{
  /**
   * A view is no input: it is not up to date because the layers are, and they stay as they are when
   * it changes.
   */
  void PostUpdateData(bool usingCache) override;
  void MarkDirtyFromProducer(
    vtkSMProxy* modified, vtkSMProxy* producer, vtkSMProperty* property) override;
  ///@}

private:
  vtkSMRelievoLayersProxy(const vtkSMRelievoLayersProxy&) = delete;
  void operator=(const vtkSMRelievoLayersProxy&) = delete;

  vtkSMViewProxy* GetView();
  vtkSMRelievoCaptureProxy* GetCapture();

  void Connect();
  void Watch(vtkSMViewProxy* view);
  void Grab(bool quiet);
  void Publish();

  void OnPushed(vtkObject*, unsigned long, void* name);
  void OnViewStarts(vtkObject*, unsigned long, void* interactive);
  void OnViewEnds();
  void OnUnregistered(vtkObject*, unsigned long, void* what);

  bool Connected = false; // the algorithm knows its capture
  bool Wanted = true;     // what the properties say has not been grabbed
  bool Early = false;     // the view was drawn for its layers only
  bool Pushing = false;   // in UpdateVTKObjects()
  bool Grabbing = false;  // in Grab()
  bool Started = false;   // the view draws a picture that is grabbed
  unsigned long ManagerTag = 0;
  unsigned long StartTag = 0;
  unsigned long EndTag = 0;
  vtkWeakPointer<vtkSMViewProxy> Watched;
};

#endif
