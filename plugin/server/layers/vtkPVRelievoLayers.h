// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoLayers
 * @brief The layers of a vtkPVRelievoCapture as a pipeline source.
 *
 * The algorithm of "Relievo Layers" in ParaView's Sources menu. It draws nothing itself: its output
 * is the capture's image, empty on processes without it.
 */
#ifndef vtkPVRelievoLayers_h
#define vtkPVRelievoLayers_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkSmartPointer.h"              // for the capture
#include "vtkWeakPointer.h"               // for the view

class vtkPVRelievoCapture;
class vtkPVView;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoLayers : public vtkImageAlgorithm
{
public:
  static vtkPVRelievoLayers* New();
  vtkTypeMacro(vtkPVRelievoLayers, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The view of the layers; nullptr if that view is closed. */
  void SetView(vtkPVView* view);
  vtkPVView* GetView();
  ///@}

  /** The source of the layers. Modified() announces new ones. */
  void SetCapture(vtkPVRelievoCapture* capture);

protected:
  vtkPVRelievoLayers();
  ~vtkPVRelievoLayers() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkPVRelievoLayers(const vtkPVRelievoLayers&) = delete;
  void operator=(const vtkPVRelievoLayers&) = delete;

  vtkWeakPointer<vtkPVView> View;
  vtkSmartPointer<vtkPVRelievoCapture> Capture;
};

#endif
