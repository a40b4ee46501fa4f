// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoCapture
 * @brief Takes the layers of a render view's next picture, on every process that draws it.
 *
 * The view draws its picture as ever; its frame makes the layers beside it, so that no rendering
 * happens that ParaView does not know of. Then they are read where they are: on the process that
 * drew all, or on all servers, whose layers are put together by depth (vtkPVRelievoLayerMerge). The
 * image, as vtkRelievoLayerSource makes it, ends on the root of the servers, on the client, or
 * where it was made.
 *
 * Start() and Stop() are called on all processes that may draw, Read() where the picture was drawn;
 * vtkSMRelievoCaptureProxy does it in the right order.
 */
#ifndef vtkPVRelievoCapture_h
#define vtkPVRelievoCapture_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

#include <memory> // for the internals

class vtkImageData;
class vtkPVView;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoCapture : public vtkObject
{
public:
  static vtkPVRelievoCapture* New();
  vtkTypeMacro(vtkPVRelievoCapture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The view whose layers are taken: a vtkPVRenderView. */
  void SetView(vtkPVView* view);

  ///@{
  /**
   * The layers, by name, in the order of the image's arrays. `color` is the picture as it is seen,
   * annotations included.
   */
  void AddLayer(const char* name);
  void RemoveAllLayers();
  ///@}

  ///@{
  /** From Start() to Stop() the view's pictures make the layers. */
  void Start();
  void Stop();
  ///@}

  /**
   * Reads the layers of the last picture, all but `color`. With `together`, called on all servers:
   * each has drawn its part of the scene, and the image is on the root. Where several parts make
   * the layer `cell`, the array `process` tells whose cells they are. With `quiet`, layers that
   * cannot be read are no error.
   */
  void Read(bool together, bool quiet);

  /**
   * Adds `color` if it is asked for: on the process that shows the picture, after Read(). Not after
   * an error there.
   */
  void ReadColor();

  ///@{
  /**
   * Moves the image between the client and the servers' root, which may both have part of it;
   * called on both. Without a server nothing moves.
   */
  void MoveToServer();
  void MoveToClient();
  ///@}

  /** The layers: without points before Read(), after an error, and where the image is not. */
  vtkImageData* GetImage();

protected:
  vtkPVRelievoCapture();
  ~vtkPVRelievoCapture() override;

private:
  vtkPVRelievoCapture(const vtkPVRelievoCapture&) = delete;
  void operator=(const vtkPVRelievoCapture&) = delete;

  void Move(bool toServer);
  void Arrange();

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
