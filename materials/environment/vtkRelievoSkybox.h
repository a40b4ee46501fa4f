// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSkybox
 * @brief Shows an environment behind all other geometry.
 *
 * Add it to a renderer like any prop (vtkRenderer::AddViewProp). The environment is infinitely far
 * away: it rotates with the view, and translation does not move it. Each pixel shows the direction
 * of its own ray, computed from the camera's matrices in double precision, at any view angle, far
 * from the origin, off axis, sheared, in stereo and in tiles.
 *
 * In a parallel projection all rays are parallel, so by default the background has a single colour.
 * ParallelViewAngle shows the background of a perspective view with that angle instead.
 *
 * A skybox writes no depth, so layers have their background values there; it casts no shadow, has
 * no bounds, and cannot be picked.
 */
#ifndef vtkRelievoSkybox_h
#define vtkRelievoSkybox_h

#include "vtkProp.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro

#include <memory> // for the internals

class vtkMatrix3x3;
class vtkRelievoEnvironment;
class vtkRenderer;

class VTKRELIEVOMATERIALS_EXPORT vtkRelievoSkybox : public vtkProp
{
public:
  static vtkRelievoSkybox* New();
  vtkTypeMacro(vtkRelievoSkybox, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The environment to show. nullptr (default): none. */
  void SetEnvironment(vtkRelievoEnvironment* environment);
  vtkRelievoEnvironment* GetEnvironment();
  ///@}

  ///@{
  /** Blur by the environment's levels, 0 to 1. Default 0. */
  vtkSetClampMacro(Roughness, double, 0.0, 1.0);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /**
   * In parallel projections, the full vertical angle of the sky over the picture's height, in
   * degrees, 0 to 170. Default 0: the single direction of the rays.
   */
  vtkSetClampMacro(ParallelViewAngle, double, 0.0, 170.0);
  vtkGetMacro(ParallelViewAngle, double);
  ///@}

  /**
   * Matrix from (x, y, 1) to the visible direction in the environment, of any length; x and y are
   * from -1 to 1 in the renderer's viewport.
   */
  void GetScreenToEnvironment(vtkRenderer* renderer, vtkMatrix3x3* matrix);

  ///@{
  /** Called by the renderer. */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkRelievoSkybox();
  ~vtkRelievoSkybox() override;

  double Roughness = 0.0;
  double ParallelViewAngle = 0.0;

private:
  vtkRelievoSkybox(const vtkRelievoSkybox&) = delete;
  void operator=(const vtkRelievoSkybox&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
