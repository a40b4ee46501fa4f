// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoCapture
 * @brief Reads the layers of a render view's next picture, on every process that draws it.
 *
 * The view draws its picture as usual; its frame makes the layers with it, without any rendering
 * unknown to ParaView. They are read where they are: on the process that drew everything, or on all
 * servers, whose layers are merged by depth (vtkPVRelievoLayerMerge). The image, as in
 * vtkRelievoLayerSource, ends on the servers' root, on the client, or where it was made.
 *
 * Start() and Stop() are called on all processes that may draw, Read() where the picture was drawn;
 * vtkSMRelievoCaptureProxy calls them in the right order.
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

  /** The view to read from: a vtkPVRenderView. */
  void SetView(vtkPVView* view);

  ///@{
  /**
   * The layers, by name, in the order of the image's arrays. `color` is the final picture,
   * including annotations.
   */
  void AddLayer(const char* name);
  void RemoveAllLayers();
  ///@}

  ///@{
  /** Between Start() and Stop() the view's pictures make the layers. */
  void Start();
  void Stop();
  ///@}

  /**
   * Reads the layers of the last picture, all but `color`. With `together`, it is called on all
   * servers: each has drawn its part of the scene, and the image is on the root. If several parts
   * make the layer `cell`, the array `process` gives the owner of the cells. With `quiet`,
   * unreadable layers are no error.
   */
  void Read(bool together, bool quiet);

  /**
   * Adds `color` if it is requested: on the process that shows the picture, after Read(). Does
   * nothing there after an error.
   */
  void ReadColor();

  ///@{
  /**
   * Moves the image between the client and the servers' root, each of which may have a part of it;
   * called on both. Without a server nothing moves.
   */
  void MoveToServer();
  void MoveToClient();
  ///@}

  /** The layers: empty before Read(), after an error, and on processes without the image. */
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
