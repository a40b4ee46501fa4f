// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoLayers
 * @brief The layers that a vtkPVRelievoCapture took, in the pipeline.
 *
 * The algorithm of "Relievo Layers" in ParaView's Sources menu. Draws nothing itself: its output is
 * the capture's image, empty on the processes that have none of it.
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
  /** Whose layers they are; nullptr if that view is closed. */
  void SetView(vtkPVView* view);
  vtkPVView* GetView();
  ///@}

  /** Where the layers come from. Modified() tells that it has new ones. */
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
