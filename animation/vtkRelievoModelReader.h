// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoModelReader
 * @brief Reads models with bones and plays their animations.
 *
 * Reads what Assimp reads: Collada (.dae), glTF, FBX, BVH, X, MS3D, SMD, MD5, IQM and more. It
 * offers the times of the chosen animation (TIME_STEPS: its keys, irregular as they are;
 * TIME_RANGE) and answers the time that is asked for, so that the time controls of VTK and ParaView
 * play it.
 *
 * Port 0 is a vtkMultiBlockDataSet with a polydata block for each mesh of each node, named as in
 * the file, in world coordinates. Point arrays: `joints` (int; places in the mesh's list of bones,
 * the strongest first, -1 for none), `weights` (float, sum 1), `Normals`, `TextureCoordinates` and
 * `RGBA` where the file has them. Field data: `base_color`, `base_color_texture`, `normal_texture`
 * (names as in the file), and, at rest only, the bones for vtkRelievoSkin. A mesh without bones
 * follows its node: one bone, weight 1.
 *
 * Port 1 is the skeleton: a point for each node of the file's tree, with the point arrays `pose`,
 * `pose_before`, `pose_after` (16 components, by rows: node to world), `parent`, `is_bone`, `name`,
 * the field data `key_share`, and lines between joints.
 *
 * Between keys, positions and scales are linear, rotations take the shorter arc; before the first
 * key and after the last these hold. What was mended or left out while reading is in GetNote().
 *
 * Limits: the up axis and unit are those that Assimp gives; morph targets are not played; keys of
 * glTF's CUBICSPLINE and STEP are played as linear.
 *
 * Errors: one error event names the file and what is wrong; GetErrorCode() is set and the output is
 * empty. A file is read again only when it or its name has changed, not when the time has.
 */
#ifndef vtkRelievoModelReader_h
#define vtkRelievoModelReader_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkRelievoAnimationModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for what was read

class vtkPolyData;
class vtkStringArray;

class VTKRELIEVOANIMATION_EXPORT vtkRelievoModelReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkRelievoModelReader* New();
  vtkTypeMacro(vtkRelievoModelReader, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Whether the file exists and Assimp reads its extension. */
  static bool CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /** Name of the animation to play; empty plays the first. Default: empty. */
  vtkSetStringMacro(Animation);
  vtkGetStringMacro(Animation);
  ///@}

  enum Poses
  {
    POSE_REST = 0,      ///< meshes as the file holds them, each in its node's place
    POSE_NODES = 1,     ///< bones where the nodes' own matrices put them, without an animation
    POSE_ANIMATION = 2, ///< bones where the animation puts them
  };

  ///@{
  /**
   * What the bones do. Without an animation POSE_ANIMATION is POSE_NODES. The skeleton at POSE_REST
   * is that of POSE_ANIMATION, which vtkRelievoSkin then applies. Default: POSE_ANIMATION.
   */
  vtkSetClampMacro(Pose, int, POSE_REST, POSE_ANIMATION);
  vtkGetMacro(Pose, int);
  ///@}

  ///@{
  /** How bones are blended: a method of vtkRelievoSkin. Default: vtkRelievoSkin::LINEAR. */
  vtkSetClampMacro(Method, int, 0, 2);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /** Most bones of a point; the strongest are kept and rescaled. 1 to 8. Default: 4. */
  vtkSetClampMacro(WeightsPerPoint, int, 1, 8);
  vtkGetMacro(WeightsPerPoint, int);
  ///@}

  ///@{
  /** Whether rotations have constant speed between keys (slerp); otherwise nlerp. Default: on. */
  vtkSetMacro(Slerp, bool);
  vtkGetMacro(Slerp, bool);
  vtkBooleanMacro(Slerp, bool);
  ///@}

  ///@{
  /**
   * Whole keys a second that method KEY_MATRIX blends, from the animation's start; 0 takes every
   * time at which any node has a key. Default: 0.
   */
  vtkSetClampMacro(KeyRate, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(KeyRate, double);
  ///@}

  ///@{
  /** Whether times after the end start anew; otherwise the end holds. Default: off. */
  vtkSetMacro(Loop, bool);
  vtkGetMacro(Loop, bool);
  vtkBooleanMacro(Loop, bool);
  ///@}

  ///@{
  /** Seconds of the animation in a unit of pipeline time, above 0. Default: 1. */
  vtkSetClampMacro(Speed, double, 1e-6, 1e6);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /** The animations of the file, after UpdateInformation(). */
  int GetNumberOfAnimations();
  const char* GetAnimationName(int index); ///< null when there is none
  vtkStringArray* GetAnimationNames();     ///< all of them
  ///@}

  ///@{
  /** What was mended or left out while reading, a sentence each. */
  int GetNumberOfNotes();
  const char* GetNote(int index); ///< null when there is none
  ///@}

protected:
  vtkRelievoModelReader();
  ~vtkRelievoModelReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoModelReader(const vtkRelievoModelReader&) = delete;
  void operator=(const vtkRelievoModelReader&) = delete;

  // Whether there is a model; reads it when what it depends on has changed.
  bool Read();
  // The place of the chosen animation, or -1 without one.
  int FindAnimation();
  // The skeleton at a pipeline time.
  void MakeSkeleton(double time, vtkPolyData* skeleton);

  char* FileName = nullptr;
  char* Animation = nullptr;
  int Pose = POSE_ANIMATION;
  int Method = 0;
  int WeightsPerPoint = 4;
  bool Slerp = true;
  double KeyRate = 0.;
  bool Loop = false;
  double Speed = 1.;

  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
