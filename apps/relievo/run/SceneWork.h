// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Helpers of commands that work on a scene.
 */
#ifndef SceneWork_h
#define SceneWork_h

#include "Progress.h"

#include "vtkRelievoScene.h"

#include <string>
#include <vector>

namespace cli
{
/// While it lives, prints the scene's steps to the error output.
class SceneSteps
{
public:
  explicit SceneSteps(vtkRelievoScene* scene);
  ~SceneSteps();
  SceneSteps(const SceneSteps&) = delete;
  void operator=(const SceneSteps&) = delete;

private:
  void Show(double share);

  vtkRelievoScene* Scene;
  unsigned long Observer;
  std::string What;
  reading::Progress Shown;
};

/// The command's scene, which lives until the process ends: VTK takes down the buffers of many
/// objects in time that grows with the square of their number, and the kernel frees them at once.
vtkRelievoScene* GetScene();

/// Throws UsageError or WorkError for a function that returned false, by its `failure` and `text`.
void CheckDone(bool done, int failure, const std::string& text);

/// Gives the scene its words.
void SetWords(vtkRelievoScene* scene, const std::vector<std::string>& words);

/// Prints the notes and warnings of the scene's last work.
void PrintMessages(vtkRelievoScene* scene);

/// Prints warnings of other code since then.
void PrintWarnings();
}

#endif
