// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * @brief The reference scenes: real meshes on a square ground, one camera, one light.
 *
 * The mesh is turned to y up, scaled so that its longest side is 2, centred on x and z, and rests
 * on a square ground of half width 3 at y = 0; the camera stands at (2.5, 3, 6) and looks at
 * (0, 0.5, 0), y up, view angle 30 degrees, clip 2 to 14; the light is at, or its sun towards,
 * (3, 5, 2); shading is flat.
 */
#ifndef relievoTestScenes_h
#define relievoTestScenes_h

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace relievoTest
{
class EmbreeScene;

/** The light of a reference scene. */
enum class SceneLight
{
  /** Directional, towards (3, 5, 2). */
  Sun,
  /** At (3, 5, 2), aimed at the origin, cone angle 60 degrees (half the opening). */
  Spot,
  /** At (3, 5, 2), in all directions. */
  Point
};

/** A scene ready to render: put the renderer into a window (MakeWindow of Window.h). */
struct ReferenceScene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Ground;
  vtkSmartPointer<vtkActor> MeshActor;
  vtkSmartPointer<vtkActor> GroundActor;
  vtkSmartPointer<vtkLight> Light;

  /** False if the mesh could not be read, which is then counted as a failure. */
  bool IsValid() const { return this->Mesh != nullptr; }

  /** The scene's actors for the truth: actor 0 is the mesh, actor 1 the ground. */
  std::shared_ptr<EmbreeScene> MakeTruth() const;
};

/** Names of the reference meshes: bunny, motorBike, buildings. */
std::vector<std::string> ReferenceMeshes();

/** Names of the other real meshes, for outside checks: armadillo, elephant. */
std::vector<std::string> OtherMeshes();

/**
 * The mesh as in the file (.off or .obj below RELIEVO_DATA): points in float, polygons, no arrays.
 * Null, with a counted failure, for an unknown name or a missing file.
 */
vtkSmartPointer<vtkPolyData> LoadMesh(const std::string& name);

/**
 * Rotated (from z up if `zUp`), scaled, centred and put on y = 0, as described above. Points are
 * transformed in double and stored in float, the precision of the graphics card.
 */
vtkSmartPointer<vtkPolyData> PlaceMesh(vtkPolyData* mesh, bool zUp);

/** The square of half width `half` at y = 0, facing up: one cell of four points. */
vtkSmartPointer<vtkPolyData> MakeGround(double half = 3.);

/** Sets the reference camera on a renderer. */
void SetReferenceCamera(vtkRenderer* renderer);

/** Makes the scene with one of the real meshes. */
ReferenceScene MakeReferenceScene(const std::string& mesh, SceneLight light = SceneLight::Sun);

/** Makes the scene with the caller's mesh, already placed. */
ReferenceScene MakeReferenceScene(vtkPolyData* mesh, SceneLight light = SceneLight::Sun);
}

#endif
