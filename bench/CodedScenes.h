// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CodedScenes.h
 * @brief Scenes for the benches of shadows: the real meshes, and shapes made by code.
 *
 * The shapes are triangles like the meshes: what is drawn and what the rays meet is the same, so no
 * verdict is wrong for the corners of a sphere.
 */
#ifndef relievoBenchCodedScenes_h
#define relievoBenchCodedScenes_h

#include "Scenes.h"

#include <string>

namespace relievoBench
{
/**
 * Spheres and poles on the ground of the reference scenes; two rows of poles to the horizon,
 * seen from a man's height; thin slabs (1/100) that lie askew on each other and on a thick one.
 */
constexpr const char* SpheresScene = "spheres";
constexpr const char* HorizonScene = "horizon";
constexpr const char* SlabsScene = "slabs";

/** Those of MadeMeshes.h on the ground of the reference scenes; the folds, which hide it. */
constexpr const char* FinsScene = "fins";
constexpr const char* FoldsScene = "folds";
constexpr const char* ArrowsScene = "arrows";
constexpr const char* TreeScene = "tree";

/** A light of these scenes; at, or its sun towards, (3, 5, 2) unless Elevation says otherwise. */
struct ShadowLight
{
  const char* Name;
  relievoTest::SceneLight Kind;
  double Elevation; // of a sun over the ground, degrees; 0: as it is
};

/**
 * The mesh of that scene, one of the above or of ReferenceMeshes(). Null, with a message on the
 * standard error, when its file is not there.
 */
vtkSmartPointer<vtkPolyData> ShadowSceneMesh(const std::string& name);

/**
 * The scene of that name with that mesh, for verdicts by pictures: white and diffuse, without
 * ambient light, and a spot as bright at its rim as on its axis.
 */
relievoTest::ReferenceScene MakeShadowScene(
  const std::string& name, vtkPolyData* mesh, const ShadowLight& light);
}

#endif
