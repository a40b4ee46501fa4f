// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLensPicture
 * @brief The colour that a lens or a panorama sees, of a renderer's scene.
 *
 * OpenGL draws the picture of a pinhole. The frame is drawn in a pinhole around all rays of the
 * sensor, or, if these are wider than 50 degrees from the axis, in the faces of a cube that they
 * hit, with everything a frame has: light, shadows, environments, stages. Each pixel of the sensor
 * takes the colour, in linear light, where its ray passes, between the four nearest pixels of that
 * picture. These are no wider than a pixel of the sensor, or than half the longer side of a pixel
 * that is long and thin, as those near the poles of a panorama. Pinholes without distortion and
 * orthographic cameras are drawn as they are.
 *
 * Lights that follow the camera shine as for a camera with the sensor's pose. Clipping planes are
 * fitted to the scene. Texts and bars are left out. A gradient behind the scene spans the sensor's
 * picture; pixels without a ray, beside a fisheye's circle, are black, with alpha 0.
 *
 * Output: vtkImageData of the sensor's columns and rows, row 0 at the bottom, with the point arrays
 * - color: 4 floats, linear light and alpha, as vtkRelievoLayerSource has it: of pictures for
 *   display, with smooth edges, or with HDR of the linear colour, unclamped; where the stage `tone`
 *   makes the picture, the light before it.
 * - picture, if asked for, and then the scalars: 3 bytes, sRGB, for display; automatic exposure is
 *   one for all views.
 * The field data has the calibration (vtkRelievoCameraModel::AddTo).
 *
 * The renderer, its window's size, camera, lights and background are afterwards as before.
 *
 * Errors: no renderer, window or sensor; a sensor whose rays begin at several places, or are beams;
 * a background by a texture; a layer that is shown as the picture (GetErrorCode is
 * vtkErrorCode::UserError for these three); those of vtkRelievoLayerSource.
 */
#ifndef vtkRelievoLensPicture_h
#define vtkRelievoLensPicture_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkSmartPointer.h"        // for the inputs

#include <vector> // for marks

class vtkFloatArray;
class vtkRelievoCameraModel;
class vtkRelievoLensViews;
struct vtkRelievoLensView;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoLensPicture : public vtkImageAlgorithm
{
public:
  static vtkRelievoLensPicture* New();
  vtkTypeMacro(vtkRelievoLensPicture, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer, which must be in a render window, and the sensor that sees it. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  void SetCamera(vtkRelievoCameraModel* camera);
  vtkRelievoCameraModel* GetCamera();
  ///@}

  ///@{
  /** How many drawn pixels there are for one of the sensor, each way, 0.25 to 8; default 1. */
  vtkSetClampMacro(Oversampling, double, 0.25, 8.0);
  vtkGetMacro(Oversampling, double);
  ///@}

  ///@{
  /** Whether the colour is unclamped; default off. */
  vtkSetMacro(HDR, bool);
  vtkGetMacro(HDR, bool);
  vtkBooleanMacro(HDR, bool);
  ///@}

  ///@{
  /** Whether the array `picture` is made; default off. */
  vtkSetMacro(Picture, bool);
  vtkGetMacro(Picture, bool);
  vtkBooleanMacro(Picture, bool);
  ///@}

  /** Pictures of pinholes that the last update has drawn, and their pixels in all. */
  int GetNumberOfViews() { return this->NumberOfViews; }
  vtkIdType GetNumberOfDrawnPixels() { return this->NumberOfDrawnPixels; }

  /** Always newer than before, because the scene may change without notice. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoLensPicture();
  ~vtkRelievoLensPicture() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRelievoLensPicture(const vtkRelievoLensPicture&) = delete;
  void operator=(const vtkRelievoLensPicture&) = delete;

  vtkSmartPointer<vtkFloatArray> DrawAll(bool isPicture);
  bool DrawViews(vtkFloatArray* color, bool isPicture);
  bool DrawWhole(vtkFloatArray* color, bool isPicture);
  void PutBehind(const vtkRelievoLensViews& views, const vtkRelievoLensView& view);
  bool IsMetered();
  bool IsDrawn(float alpha, float depth);

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRelievoCameraModel> Camera;
  double Oversampling = 1.0;
  bool HDR = false;
  bool Picture = false;
  int NumberOfViews = 0;
  vtkIdType NumberOfDrawnPixels = 0;

  // While it draws.
  bool Gradient = false;
  std::vector<unsigned char> Marks; // of each pixel: 0 the background, 1 drawn, 2 unseen
};

#endif
