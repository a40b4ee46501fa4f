// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkinnedScenes.h
 * @brief One mesh with bones drawn twice: moved by the vertex shader, and by vtkRelievoSkin.
 */
#ifndef SkinnedScenes_h
#define SkinnedScenes_h

#include "GLCheck.h"
#include "SkinScenes.h"
#include "Stage.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoSkin.h>
#include <vtkRelievoSkinnedActor.h>

#include <string>

class vtkImageData;

namespace relievoTest
{
/** The name of a method of vtkRelievoSkin. */
std::string MethodName(int method);

/** A method of vtkRelievoShadowStage. */
struct ShadowMethod
{
  const char* Name;
  int Value;
};
constexpr ShadowMethod ShadowMethods[] = { { "map", vtkRelievoShadowStage::METHOD_MAP },
  { "forward", vtkRelievoShadowStage::METHOD_FORWARD },
  { "warped", vtkRelievoShadowStage::METHOD_WARPED },
  { "exact", vtkRelievoShadowStage::METHOD_EXACT } };

/** The mesh by either, in a window of its own. */
struct SkinnedSide
{
  explicit SkinnedSide(bool gpu, int width = 240, int height = 180);

  void Set(vtkPolyData* mesh, vtkPolyData* skeleton, int method);
  vtkPolyDataMapper* GetMapper();

  relievoTest::Stage Stage;
  GLCheck Watch;
  vtkNew<vtkRelievoSkin> Skin;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkSmartPointer<vtkRelievoSkinnedActor> Skinned; // null by vtkRelievoSkin
  vtkSmartPointer<vtkActor> Actor;
};

/** Both, seen alike. */
struct SkinnedPair
{
  explicit SkinnedPair(int width = 240, int height = 180);

  /** Sets both, and looks at the mesh from the direction (1, -2, 1.5). */
  void Set(vtkPolyData* mesh, vtkPolyData* skeleton, int method);

  /**
   * Fails unless layers agree: where ids or coverage differ, the pixel lies within 1/256 of a
   * projected edge; elsewhere the surfaces are within 2e-6 of the mesh's size, and normals within a
   * thousandth.
   */
  void CompareLayers(const std::string& what);

  /** Fails if more than `share` of the pixels differ by more than `slack` of 255. */
  void ComparePictures(const std::string& what, double share, int slack = 3);

  /** Whether a pixel lies within `distance` pixels of an edge of the moved mesh. */
  bool IsNearEdge(int x, int y, double distance);

  SkinnedSide CPU;
  SkinnedSide GPU;
};

/** A tube with three bones, the second and third bent, stretched, and mirrored by `mirror` < 0. */
vtkSmartPointer<vtkPolyData> MakeThreeBoneTube(int rings, int sides);
vtkSmartPointer<vtkPolyData> MakeBentPose(double turn, double stretch, double mirror);

/** A tube along a chain of bones, each turned a little against the one before. */
struct Chain
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Skeleton;
};
Chain MakeChain(int bones, int rings, int sides, int influences);
}

#endif
