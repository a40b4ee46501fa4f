// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRelievoLayersProxy
 * @brief Proxy of the source "Relievo Layers", which decides when to grab a view's layers.
 *
 * It grabs when a property of the layers is set, at the command GrabAgain, with FollowView after
 * each picture of the view at full quality, and after the first picture of a view that had none
 * when the layers were requested (in a state file, before its scene exists). Otherwise the layers
 * stay unchanged.
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
   * A view is not a pipeline input: updating the layers does not update the view, and a change of
   * the view does not invalidate the layers.
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

  bool Connected = false; // whether the algorithm has its capture
  bool Wanted = true;     // whether properties have changed since the last grab
  bool Early = false;     // whether the view was drawn for its layers only
  bool Pushing = false;   // in UpdateVTKObjects()
  bool Grabbing = false;  // in Grab()
  bool Started = false;   // whether the view is drawing a picture to grab
  unsigned long ManagerTag = 0;
  unsigned long StartTag = 0;
  unsigned long EndTag = 0;
  vtkWeakPointer<vtkSMViewProxy> Watched;
};

#endif
