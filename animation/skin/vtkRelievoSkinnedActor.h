// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSkinnedActor
 * @brief A mesh with bones that the vertex shader moves.
 *
 * Its inputs and methods are those of vtkRelievoSkin, and so are the places of points, normals and
 * tangents, but for the rounding of floats. Here the mesh stays on the graphics card, and a new
 * pose changes a texture of bones. That fits meshes that move often; where the moved points are to
 * be measured or written, vtkRelievoSkin gives them.
 *
 * The actor has a vtkPolyDataMapper of its own, for colors and textures as usual. Its
 * vtkShaderProperty has replacements of `in vec4 vertexMC;`, `in vec3 normalMC;`,
 * `in vec3 tangentMC;` and `//VTK::CustomBegin::Impl`, which must stay. Layers, shadow maps, fog
 * and VTK's pickers by hardware (vtkHardwareSelector, vtkPropPicker) see the moved mesh, and the
 * bounds follow the pose. vtkCellPicker and vtkPointPicker read the mapper's mesh, which is at
 * rest: give their pick lists an actor of GetMovedMesh(). Shadows of the method `exact` follow the
 * pose on the CPU. Where VTK lets no stage light actors with shader code of their own (deferred
 * shading), VTK lights it.
 *
 * The skeleton is brought up to date with each frame. Only a pose that differs from the one before
 * counts as a change, and draws shadow maps anew.
 *
 * Far from the origin, where floats have few digits, points and bones are about the middle of the
 * mesh and of the pose, and VTK's matrices have the rest in double; GetMovedMesh() then has points
 * in double. The mapper's own input is about that middle, too: take the mesh from where it came.
 *
 * Limits: at most 8 bones move a point; the weaker ones are left out, with a warning.
 *
 * Errors: one error event says what is missing; the mesh is then drawn at rest.
 */
#ifndef vtkRelievoSkinnedActor_h
#define vtkRelievoSkinnedActor_h

#include "vtkNew.h" // for the mapper
#include "vtkOpenGLActor.h"
#include "vtkRelievoAnimationModule.h" // for the export macro
#include "vtkRelievoMovedMesh.h"       // for passes that process triangles

#include <memory> // for the internals
#include <string> // for error messages

class vtkAlgorithmOutput;
class vtkPolyDataMapper;

class VTKRELIEVOANIMATION_EXPORT vtkRelievoSkinnedActor
  : public vtkOpenGLActor
  , public vtkRelievoMovedMesh
{
public:
  static vtkRelievoSkinnedActor* New();
  vtkTypeMacro(vtkRelievoSkinnedActor, vtkOpenGLActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mesh at rest, polydata with bones, as port 0 of vtkRelievoSkin takes it; a composite needs
   * an actor for each block.
   */
  void SetInputConnection(vtkAlgorithmOutput* port);
  void SetInputData(vtkPolyData* mesh);
  ///@}

  ///@{
  /** The skeleton, as port 1 of vtkRelievoSkin takes it. */
  void SetSkeletonConnection(vtkAlgorithmOutput* port);
  void SetSkeletonData(vtkPolyData* skeleton);
  ///@}

  ///@{
  /** The blending of bones: a method of vtkRelievoSkin. Default: vtkRelievoSkin::LINEAR. */
  void SetMethod(int method);
  int GetMethod();
  ///@}

  ///@{
  /** Whether the mesh is drawn at rest, independently of the skeleton. Default: off. */
  vtkSetMacro(BindPose, bool);
  vtkGetMacro(BindPose, bool);
  vtkBooleanMacro(BindPose, bool);
  ///@}

  /** The mapper that draws the mesh. */
  vtkPolyDataMapper* GetPolyDataMapper();

  /** The mesh as drawn, moved on the CPU by vtkRelievoSkin; nullptr without a mesh. */
  vtkPolyData* GetMovedMesh() override;

  using vtkOpenGLActor::GetBounds;
  /**
   * A box around the moved mesh, from boxes of each bone's points: with bent joints slightly larger
   * than the mesh itself.
   */
  double* GetBounds() override;
  /** The box around the moved mesh before the actor's matrix; uninitialized without a mesh. */
  void GetMovedBounds(double bounds[6]) override;

  vtkMTimeType GetRedrawMTime() override;
  double GetRoundedReach() override;
  int GetNumberOfMovingReplacements() const override;
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  ///@{
  /**
   * The actor's matrix; only VTK's mapper, while it draws a mesh far from the origin, gets one that
   * starts at the shader's points.
   */
  using vtkOpenGLActor::GetMatrix;
  vtkMatrix4x4* GetMatrix() override;
  void GetMatrix(vtkMatrix4x4* result) override;
  int GetIsIdentity() override;
  void GetKeyMatrices(vtkMatrix4x4*& toWorld, vtkMatrix3x3*& normals) override;
  ///@}
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoSkinnedActor();
  ~vtkRelievoSkinnedActor() override;

private:
  struct Internals;

  void Disconnect();
  vtkPolyData* UpdateMesh();
  void UpdatePose();
  void Complain(const std::string& error);
  void Refuse(const std::string& error);
  void SetUniforms(vtkObject*, unsigned long, void* program);

  std::unique_ptr<Internals> Internal;
  vtkNew<vtkPolyDataMapper> Mesh;
  bool BindPose = false;

  vtkRelievoSkinnedActor(const vtkRelievoSkinnedActor&) = delete;
  void operator=(const vtkRelievoSkinnedActor&) = delete;
};

#endif
