// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoRayScene
 * @brief The first hits of rays, whether they hit anything, and all their hits, in double.
 *
 * The scene is a renderer's content (SetRenderer), or data (AddData), or both. Each query updates
 * it first: unchanged parts are kept, moved points and matrices are refitted, and other changes
 * cause a rebuild. Each mesh is stored once, however many actors, glyphs or matrices place it.
 *
 * Surfaces are hit from both sides, whatever their culling: for a renderer the triangles that VTK
 * draws of meshes, blocks and glyphs; for data polygons, convex or not, and strips (for data other
 * than vtkPolyData those of the outer surface). Hidden props and blocks, and surfaces of opacity 0,
 * are excluded. Geometry under a singular matrix, or one whose last row is not 0 0 0 1, is hit in
 * world coordinates. For a renderer, unsupported geometry is left out, with one warning: volumes,
 * wireframes, points, lines, impostors, cut-outs, clipped meshes, grids drawn by vtkDataSetMapper,
 * actors with their own shaders, or with matrices that are not finite or map points to infinity
 * (GetNumberOfPropsLeftOut). No ray hits a triangle with a corner that is not finite.
 *
 * A ray has an origin and a direction of any length but 0, in world coordinates; distances are in
 * world units from the origin. Rays that are not finite, or have no direction, hit nothing, with
 * one warning; a direction of NaN in all components marks a missing ray, which hits nothing without
 * a warning. Triangles include their edges: no ray passes between two triangles that share one (S.
 * Woop, C. Benthin, I. Wald, Watertight ray/triangle intersection, 2013).
 *
 * Rays run on all cores, in batches; ProgressEvent, with the completed share, is sent between the
 * batches on the calling thread, and AbortOn() in its observer aborts the call, which then returns
 * false.
 */
#ifndef vtkRelievoRayScene_h
#define vtkRelievoRayScene_h

#include "vtkObject.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkRelievoText.h"       // for names of files

#include <memory> // for the data that is not shown here
#include <string> // for messages

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
   * The renderer whose visible props can be hit; default: none. It is not drawn, but the input of
   * its mappers is updated.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  /**
   * Adds a vtkDataSet, or composite data of them, placed by a matrix (nullptr: the identity);
   * changes of both are taken up by each query. Returns its number as a prop, after the renderer's
   * actors.
   */
  int AddData(vtkDataObject* data, vtkMatrix4x4* matrix = nullptr);
  void RemoveAllData();

  ///@{
  /**
   * Whether rays hit only opaque surfaces of a renderer, like the layers of a frame; default: no.
   * Also applies to a copied state, if it was copied with all surfaces.
   */
  vtkSetMacro(OpaqueOnly, bool);
  vtkGetMacro(OpaqueOnly, bool);
  vtkBooleanMacro(OpaqueOnly, bool);
  ///@}

  ///@{
  /**
   * Name of a point array of integers that identifies points for FindMoved where the data are
   * meshed anew: a point and a cell of another state are followed if they have the same ids,
   * wherever they stand in the arrays. Points of a changed mesh in different places that have the
   * same id are not followed. A mesh without it identifies points by their index. Default: none.
   */
  vtkSetStringMacro(PointIds);
  vtkGetStringMacro(PointIds);
  ///@}

  ///@{
  /**
   * Range of distances for hits along a ray, in world units; default: 0 to infinity, both included.
   * At least 0.
   */
  vtkSetClampMacro(MinimumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumDistance, double);
  void SetMaximumDistance(double distance);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  /**
   * The first hit of each ray. `origins` and `directions` have three components and a tuple for
   * each ray; a single origin is used for all rays. `hits` gets a row for each ray, with the
   * columns
   *
   * - distance: in world units; infinity: no hit
   * - prop: number of the actor in vtkRenderer::GetActors(), or of AddData; -1: no hit
   * - block: flat index in composite data, 0 for other data; -1
   * - cell: in the drawn mesh; for glyphs the input's point; for data its own cell; -1
   * - points: three, the indices of the triangle's corners in the mesh, or in the data; -1
   * - weights: three, barycentric weights of these points; 0
   * - position: three, in world coordinates; 0
   * - normal: three, the shading normal of points or cells in VTK, reversed where the back is hit;
   *   the geometric normal without such normals, or with flat shading; unit; 0
   * - geometric_normal: three, of the triangle, towards the ray's origin; unit; 0
   *
   * Among hits at equal distances, the lowest prop, block and cell is returned. False, with an
   * error or after an abort; `hits` is then empty.
   */
  bool FindNearest(vtkDataArray* origins, vtkDataArray* directions, vtkTable* hits);

  /**
   * Whether each ray hits anything: 1 or 0.
   */
  bool FindAny(vtkDataArray* origins, vtkDataArray* directions, vtkUnsignedCharArray* hit);

  /**
   * All hits, one row each, ordered by rays and then by distance, with the columns of FindNearest
   * and
   *
   * - ray: number of the ray
   * - opacity: of the surface, 0 to 1; NaN if it varies over the mesh, by an array, a table or a
   *   texture. For data it is 1.
   *
   * A ray through an edge hits both of its triangles.
   */
  bool FindAll(vtkDataArray* origins, vtkDataArray* directions, vtkTable* hits);

  ///@{
  /**
   * Aborts the running query, from an observer of ProgressEvent. Reset by the next query.
   */
  vtkSetMacro(Abort, bool);
  vtkGetMacro(Abort, bool);
  vtkBooleanMacro(Abort, bool);
  ///@}

  /**
   * Updates the scene, which each query does first. Returns whether anything has changed.
   */
  bool Update();

  ///@{
  /**
   * Statistics of the last update: triangles at all places; meshes that were built, and meshes that
   * were refitted to moved points; and memory in kibibytes.
   */
  vtkIdType GetNumberOfTriangles();
  int GetNumberOfMeshesBuilt();
  int GetNumberOfMeshesRefitted();
  unsigned long GetActualMemorySize();
  ///@}

  /**
   * Writes the meshes, their trees and their normals to a file, for Read; all of them, also with
   * OpaqueOnly. An existing file is replaced when the new one is complete. The file takes as much
   * memory as the trees, has the byte order of this machine, a number of its format and a hash.
   * False, with an error, if the file cannot be written or the data have no trees.
   */
  bool Write(RELIEVO_TEXT file);

  /**
   * Reads a file of Write: its trees stay in the file, which is mapped into memory that all
   * processes share. Do not change a file that is in use; replace it, as Write does.
   *
   * If the scene has a renderer or data, the file must have been written of the same points, cells
   * and matrices; the trees are then used as if the scene had built them, and later changes are
   * followed. Otherwise the scene gets the state that was written: it has no props' data,
   * CopyMesh, CopyStateOf and FindMoved are refused, and SetRenderer and AddData start a new scene.
   *
   * False, with an error that says why, for a file that is damaged, of another format, of a machine
   * of the other byte order, or of another scene. The scene is then unchanged.
   */
  bool Read(RELIEVO_TEXT file);

  /**
   * Copies another scene's present state, with the same numbers; later changes have no effect on
   * the copy. SetRenderer and AddData start a new scene.
   */
  void CopyStateOf(vtkRelievoRayScene* other);

  /**
   * FindNearest, and the positions of the hit points in another state of the scene, copied earlier
   * or present: `places` gets three components for each ray, world coordinates, NaN if there is no
   * hit or the point no longer exists. A point is identified by its triangle's corners (PointIds)
   * and their weights; a mesh by its actor and block, or by the index in AddData's list. Also false
   * if no mesh of the other state has the array PointIds.
   */
  bool FindMoved(vtkRelievoRayScene* later, vtkDataArray* origins, vtkDataArray* directions,
    vtkTable* hits, vtkDoubleArray* places);

  ///@{
  /**
   * The objects numbered by the column `prop`: their number; the data of one, which blocks, cells
   * and points refer to, or nullptr; and whether its cells are points, as for glyphs. A copied
   * state has no data.
   */
  int GetNumberOfProps();
  vtkDataObject* GetPropData(int prop);
  bool GetIsGlyphs(int prop);
  ///@}

  ///@{
  /**
   * The meshes that rays can hit, as of the last update, and the prop and the block of each mesh's
   * hits; -1 for an invalid mesh number. CopyMesh returns a mesh in world coordinates, in double:
   * all placed glyphs, without arrays; other meshes with their arrays, except normals. The cell
   * array `cell` (vtkIdType) holds the hits' column of this name. A mirroring matrix does not swap
   * outside and inside. Error: no copy to fill, or an invalid mesh number; the copy is then
   * unchanged.
   */
  int GetNumberOfMeshes();
  int GetMeshProp(int mesh);
  int GetMeshBlock(int mesh);
  void CopyMesh(int mesh, vtkPolyData* copy);
  ///@}

  ///@{
  /**
   * The renderer's props that rays cannot hit, as of the last update.
   */
  int GetNumberOfPropsLeftOut();
  vtkProp* GetPropLeftOut(int index);
  ///@}

#ifndef __VTK_WRAP__
  // The tree of the last update.
  const vtkRelievoRayTree& GetTree() const;

  // Why rays cannot hit some of the data, as of the last update, or "".
  std::string GetFault() const;
#endif

protected:
  vtkRelievoRayScene();
  ~vtkRelievoRayScene() override;

private:
  vtkRelievoRayScene(const vtkRelievoRayScene&) = delete;
  void operator=(const vtkRelievoRayScene&) = delete;

  vtkMapper* GetMapper(int prop);
  void Collect();
  bool Begin(vtkDataArray* origins, vtkDataArray* directions, vtkObject* answer);
  void Warn(vtkIdType invalid, vtkIdType rays);

  struct Internals;
  std::unique_ptr<Internals> Internal;
  double MinimumDistance = 0.0;
  double MaximumDistance;
  bool OpaqueOnly = false;
  char* PointIds = nullptr;
  bool Abort = false;
};

#endif
