// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What commands that work on a scene share.
 */
#ifndef SceneWork_h
#define SceneWork_h

#include "Progress.h"

#include "vtkRelievoScene.h"

#include <string>
#include <vector>

namespace cli
{
/// The scene's steps on the error output, while it lives.
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
  scene::Progress Shown;
};

/// Throws UsageError or WorkError for a function that returned false; `failure` and `text` say why.
void CheckDone(bool done, int failure, const std::string& text);

/// Gives the scene its words.
void SetWords(vtkRelievoScene* scene, const std::vector<std::string>& words);

/// Prints what the user should know of the scene's last work.
void PrintMessages(vtkRelievoScene* scene);

/// Prints the warnings of others since then.
void PrintWarnings();
}

#endif
