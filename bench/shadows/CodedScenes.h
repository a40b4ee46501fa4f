// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CodedScenes.h
 * @brief Scenes for the benches of shadows: real meshes, and generated shapes.
 *
 * The shapes are triangles like the meshes: rays hit exactly the drawn triangles, so the
 * tessellation of spheres causes no errors.
 */
#ifndef relievoBenchCodedScenes_h
#define relievoBenchCodedScenes_h

#include "Scenes.h"

#include <string>

namespace relievoBench
{
/**
 * Spheres and poles on the ground of the reference scenes; two rows of poles to the horizon, seen
 * from eye height; thin slabs (1/100) lying askew on each other and on a thick one.
 */
constexpr const char* SpheresScene = "spheres";
constexpr const char* HorizonScene = "horizon";
constexpr const char* SlabsScene = "slabs";

/** The meshes of MadeMeshes.h on the ground of the reference scenes; the folds hide the ground. */
constexpr const char* FinsScene = "fins";
constexpr const char* FoldsScene = "folds";
constexpr const char* ArrowsScene = "arrows";
constexpr const char* TreeScene = "tree";

/** A light of these scenes: at (3, 5, 2), or a sun towards that unless Elevation is set. */
struct ShadowLight
{
  const char* Name;
  relievoTest::SceneLight Kind;
  double Elevation; // of a sun above the ground, degrees; 0: unchanged
};

/**
 * The mesh of a scene named above or in ReferenceMeshes(). Null, with a message on the standard
 * error, if its file is missing.
 */
vtkSmartPointer<vtkPolyData> ShadowSceneMesh(const std::string& name);

/**
 * The scene of that name with that mesh, for verdicts from pictures: white and diffuse, without
 * ambient light, and with spots of equal brightness from axis to rim.
 */
relievoTest::ReferenceScene MakeShadowScene(
  const std::string& name, vtkPolyData* mesh, const ShadowLight& light);
}

#endif
