// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelOptions.h"

#include "Failure.h"
#include "Options.h"
#include "Readers.h"
#include "Values.h"

#include <algorithm>

namespace cli
{
//------------------------------------------------------------------------------
void TakeTime(RenderOptions& options, const std::string& word)
{
  options.Model.Time = ParseNumbers("--time", word, 1, "seconds").front();
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeAnimation(RenderOptions& options, const std::string& word)
{
  options.Model.Animation = word;
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeSkin(RenderOptions& options, const std::string& word)
{
  constexpr SkinChoice kinds[] = { SkinChoice::Off, SkinChoice::Linear, SkinChoice::DualQuaternion,
    SkinChoice::KeyMatrix };
  options.Model.Skin =
    kinds[ParseChoice("--skin", word, { "off", "linear", "dual-quaternion", "key-matrix" })];
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void CheckModelOptions(const RenderOptions& options)
{
  if (options.Model.Given &&
    std::none_of(options.Files.begin(), options.Files.end(),
      [](const std::string& path) { return IsModel(path) || IsGLTF(path); }))
  {
    throw WordsError("--time, --animation and --skin: no FILE can have bones; expected one of "
                     ".bvh .dae .fbx .glb .gltf .iqm .ms3d .x");
  }
}
}
