// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoRayScene
 * @brief What rays meet first, whether they meet anything, and all that they meet, in double.
 *
 * The scene is what a renderer shows (SetRenderer), or data (AddData), or both. Each answer brings
 * it up to date first: it is kept as it is while nothing has changed, fitted where only points or
 * matrices have moved, and made again otherwise. A mesh is held once, however many actors, glyphs
 * or matrices place it.
 *
 * Surfaces are met from both sides, whatever their culling: of a renderer the triangles that VTK
 * draws of meshes, blocks and glyphs; of data polygons, convex or not, and strips (of other data
 * than vtkPolyData the outer surface's). Hidden props and blocks are not there, nor is what has an
 * opacity of 0. What a matrix flattens, or divides by a last row other than 0 0 0 1, is met as it
 * is in the world. Of a renderer, what rays cannot follow is left out, with one warning: volumes,
 * wireframes, points, lines, impostors, cut-outs, clipped meshes, grids that vtkDataSetMapper
 * draws, actors with shaders of their own, or with matrices that are not finite or send points to
 * infinity (GetNumberOfPropsLeftOut). A triangle with a corner that is not finite is met by
 * nothing.
 *
 * A ray has an origin and a direction, in world coordinates, of any length but 0; distances count
 * in world units from the origin. A ray that is not finite, or has no direction, meets nothing,
 * with one warning; one whose direction is NaN in all components is no ray, and meets nothing.
 * Triangles have their edges: no ray passes between two that share one (S. Woop, C. Benthin,
 * I. Wald, Watertight ray/triangle intersection, 2013).
 *
 * Rays run on all cores, in batches; ProgressEvent, with the share done, comes between the batches
 * on the calling thread, and AbortOn() in its observer ends the call, which then returns false.
 */
#ifndef vtkRelievoRayScene_h
#define vtkRelievoRayScene_h

#include "vtkObject.h"
#include "vtkRelievoRaysModule.h" // for the export macro

#include <memory> // for the data that is not shown here

class vtkDataArray;
class vtkDataObject;
class vtkDoubleArray;
class vtkMapper;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;
class vtkRelievoRayTree;
class vtkRenderer;
class vtkTable;
class vtkUnsignedCharArray;

class VTKRELIEVORAYS_EXPORT vtkRelievoRayScene : public vtkObject
{
public:
  static vtkRelievoRayScene* New();
  vtkTypeMacro(vtkRelievoRayScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The renderer whose visible props are met; default: none. It is not drawn, but what its mappers
   * show is updated.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  /**
   * Adds a vtkDataSet, or composite data of them, placed by a matrix (nullptr: where it is), which
   * is looked at again for each answer. Returns its number as a prop, behind the renderer's actors.
   */
  int AddData(vtkDataObject* data, vtkMatrix4x4* matrix = nullptr);
  void RemoveAllData();

  ///@{
  /**
   * Whether of a renderer only what VTK draws as opaque is met, as in the layers of a frame;
   * default: no. Of a copied state too, if it was copied with all.
   */
  vtkSetMacro(OpaqueOnly, bool);
  vtkGetMacro(OpaqueOnly, bool);
  vtkBooleanMacro(OpaqueOnly, bool);
  ///@}

  ///@{
  /**
   * From where to where along a ray there are hits, in world units; default: 0 to infinity, both
   * included. At least 0.
   */
  vtkSetClampMacro(MinimumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumDistance, double);
  void SetMaximumDistance(double distance);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  /**
   * The first hit of each ray. `origins` and `directions` have three components and a tuple for
   * each ray; one origin is that of all rays. `hits` gets a row for each ray, and columns
   *
   * - distance: in world units; infinity: none
   * - prop: number of the actor in vtkRenderer::GetActors(), or of AddData's; -1: none
   * - block: flat index in composite data, 0 for other data; -1
   * - cell: of the mesh that is drawn; of glyphs the input's point; of data, its own cell; -1
   * - points: three, the ids of the triangle's corners in the mesh, or in the data; -1
   * - weights: three, barycentric weights of these points; 0
   * - position: three, in world coordinates; 0
   * - normal: three, of points or cells as VTK lights with them, turned round where the back is
   *   met; the geometric one without such, or with flat shading; unit; 0
   * - geometric_normal: three, of the triangle, towards the ray's origin; unit; 0
   *
   * Of hits at one distance, that of the lowest prop, block and cell counts. False, with an error
   * or after an abort: `hits` is empty then.
   */
  bool FindNearest(vtkDataArray* origins, vtkDataArray* directions, vtkTable* hits);

  /**
   * Whether each ray meets anything: 1 or 0.
   */
  bool FindAny(vtkDataArray* origins, vtkDataArray* directions, vtkUnsignedCharArray* met);

  /**
   * All hits: a row each, ordered by rays and then by distance, with the columns of FindNearest and
   *
   * - ray: number of the ray
   * - opacity: of the surface, 0 to 1; NaN where it is not one for the whole mesh: by an array, a
   *   table or a texture. Of data it is 1.
   *
   * A ray through an edge meets both of its triangles.
   */
  bool FindAll(vtkDataArray* origins, vtkDataArray* directions, vtkTable* hits);

  ///@{
  /**
   * Ends the answer that is being found, from an observer of ProgressEvent. Off again when the next
   * one begins.
   */
  vtkSetMacro(Abort, bool);
  vtkGetMacro(Abort, bool);
  vtkBooleanMacro(Abort, bool);
  ///@}

  /**
   * Brings the scene up to date, as each answer does first. Returns whether anything has changed.
   */
  bool Update();

  ///@{
  /**
   * Of the scene as it was last brought up to date: triangles at all places, meshes that were made
   * anew and that were fitted to moved points by the last update, and memory in kibibytes.
   */
  vtkIdType GetNumberOfTriangles();
  int GetNumberOfMeshesBuilt();
  int GetNumberOfMeshesRefitted();
  unsigned long GetActualMemorySize();
  ///@}

  /**
   * Becomes what another scene is now: a copy, which does not follow what changes later, with the
   * same numbers. SetRenderer and AddData begin anew.
   */
  void CopyStateOf(vtkRelievoRayScene* other);

  /**
   * FindNearest, and where the points that are hit are in another state of the scene, which was
   * copied earlier or is as it is now: `places` gets three components for each ray, world
   * coordinates, NaN where nothing is hit or the point is no longer there. A point is that of its
   * triangle's corners, by their weights; a mesh is that of the same actor and block, or of data in
   * the same place of the list of AddData.
   */
  bool FindMoved(vtkRelievoRayScene* later, vtkDataArray* origins, vtkDataArray* directions,
    vtkTable* hits, vtkDoubleArray* places);

  ///@{
  /**
   * What the column `prop` counts: how many there are, and of one its data, in which blocks, cells
   * and points count, or nullptr; and whether its cells are points, as those of glyphs. A copied
   * state has none.
   */
  int GetNumberOfProps();
  vtkDataObject* GetPropData(int prop);
  bool GetIsGlyphs(int prop);
  ///@}

  ///@{
  /**
   * The meshes that rays meet, as of the last update, and the prop and the block that the hits of
   * each have; -1 for a number that is no mesh's. CopyMesh gives one in world coordinates, in
   * double: of glyphs all of them, without arrays, of others with its arrays, but normals. The cell
   * array `cell` (vtkIdType) is the column of hits by this name. What is outside stays outside
   * where a matrix mirrors. Error: nothing to copy to, or a number that is no mesh's; the copy
   * stays as it was.
   */
  int GetNumberOfMeshes();
  int GetMeshProp(int mesh);
  int GetMeshBlock(int mesh);
  void CopyMesh(int mesh, vtkPolyData* copy);
  ///@}

  ///@{
  /**
   * Props of the renderer that rays cannot follow, as of the last update.
   */
  int GetNumberOfPropsLeftOut();
  vtkProp* GetPropLeftOut(int index);
  ///@}

#ifndef __VTK_WRAP__
  // The state of the last update.
  const vtkRelievoRayTree& GetTree() const;
#endif

protected:
  vtkRelievoRayScene();
  ~vtkRelievoRayScene() override;

private:
  vtkRelievoRayScene(const vtkRelievoRayScene&) = delete;
  void operator=(const vtkRelievoRayScene&) = delete;

  vtkMapper* GetMapper(int prop);
  bool Begin(vtkDataArray* origins, vtkDataArray* directions, vtkObject* answer);
  void Warn(vtkIdType invalid, vtkIdType rays);

  struct Held;
  std::unique_ptr<Held> Scene;
  double MinimumDistance = 0.0;
  double MaximumDistance;
  bool OpaqueOnly = false;
  bool Abort = false;
};

#endif
