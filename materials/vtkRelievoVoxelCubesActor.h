// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVoxelCubesActor
 * @brief Cubes of a voxel shell as instances, whose sizes and positions are computed by the vertex
 * shader.
 *
 * The input is the output of vtkRelievoVoxelCubes with InstancedOn(). The settings, and the
 * pictures, are those of that filter; here a change of a setting only changes uniforms on the GPU,
 * so that transitions and a repeller can move in each frame. The filter's own Transition limits the
 * distance up to which there are cubes.
 *
 * The actor has a vtkGlyph3DMapper, which colors the cubes by scalars as usual; its source is a
 * cube with sides of 1. Its vtkShaderProperty has a replacement of `//VTK::Glyph::Dec` and three
 * uniforms, which must not be removed. Layers, shadow maps, lamps and fog use the drawn positions
 * of the cubes; if no stage can light actors with their own shader code (deferred shading), VTK
 * lights them. The shadow method `exact`, which traces triangles on the CPU, uses its map for them.
 */
#ifndef vtkRelievoVoxelCubesActor_h
#define vtkRelievoVoxelCubesActor_h

#include "vtkNew.h" // for the mapper
#include "vtkOpenGLActor.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkGlyph3DMapper;

class VTKRELIEVOMATERIALS_EXPORT vtkRelievoVoxelCubesActor : public vtkOpenGLActor
{
public:
  static vtkRelievoVoxelCubesActor* New();
  vtkTypeMacro(vtkRelievoVoxelCubesActor, vtkOpenGLActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The points of vtkRelievoVoxelCubes, with InstancedOn(). */
  void SetInputConnection(vtkAlgorithmOutput* port);
  void SetInputData(vtkDataObject* data);
  ///@}

  /** The mapper that draws the cubes. */
  vtkGlyph3DMapper* GetGlyphMapper();

  ///@{
  /** Sides of the cells in world units: the image's spacing. Default is 1 1 1. */
  void SetCellSize(double x, double y, double z);
  void SetCellSize(const double size[3]) { this->SetCellSize(size[0], size[1], size[2]); }
  vtkGetVector3Macro(CellSize, double);
  ///@}

  ///@{
  /** Distance outside, in world units, over which sizes fall to RestSize. Default is 0. */
  void SetTransition(double distance);
  vtkGetMacro(Transition, double);
  ///@}

  ///@{
  /** Size of cubes farther outside than Transition, 0 to 1. Default is 0.05. */
  void SetRestSize(double size);
  vtkGetMacro(RestSize, double);
  ///@}

  ///@{
  /** Factor of the sizes above RestSize, 0 to 1, for animations. Default is 1. */
  void SetGrowth(double growth);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * A point from which cubes move away, in model coordinates: a cube at distance d below
   * RepellerRadius r moves to (r + d d / r) / 2. Default radius 0: nothing moves.
   */
  void SetRepeller(double x, double y, double z);
  void SetRepeller(const double place[3]) { this->SetRepeller(place[0], place[1], place[2]); }
  vtkGetVector3Macro(Repeller, double);
  void SetRepellerRadius(double radius);
  vtkGetMacro(RepellerRadius, double);
  ///@}

  using vtkOpenGLActor::GetBounds;
  /** Bounds of the cubes at full size, and of the repeller's ball. */
  double* GetBounds() override;

protected:
  vtkRelievoVoxelCubesActor();
  ~vtkRelievoVoxelCubesActor() override;

private:
  void Change(const char* name, double* values, const double* given, int count);
  void UpdateUniforms();

  vtkNew<vtkGlyph3DMapper> Glyphs;
  double CellSize[3] = { 1., 1., 1. };
  double Transition = 0.;
  double RestSize = 0.05;
  double Growth = 1.;
  double Repeller[3] = { 0., 0., 0. };
  double RepellerRadius = 0.;

  vtkRelievoVoxelCubesActor(const vtkRelievoVoxelCubesActor&) = delete;
  void operator=(const vtkRelievoVoxelCubesActor&) = delete;
};

#endif
