// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ToneOptions.h"

#include "Errors.h"
#include "OptionRows.h"
#include "Options.h"
#include "Values.h"

namespace scene
{
namespace
{
const char* const Stage = "tone";
}

//------------------------------------------------------------------------------
namespace
{
void TakeTone(RenderOptions& options, const std::string& word)
{
  const char* const form =
    "neutral, clamp, simple, reinhard or reinhard-rgb, the latter two with ,white=W";
  const std::vector<std::string> pieces = Split(word, ',');
  const char* const operators[] = { "clamp", "simple", "reinhard", "reinhard_rgb", "neutral" };
  const std::size_t which =
    ParseChoice("--tone", pieces[0], { "clamp", "simple", "reinhard", "reinhard-rgb", "neutral" });
  StageChoice& choice = AddStage(options.Stages, Stage, "--tone");
  choice.Parameters.emplace_back("operator", operators[which]);
  for (std::size_t i = 1; i < pieces.size(); ++i)
  {
    const std::string name = "white=";
    if (i > 1 || pieces[i].rfind(name, 0) != 0)
    {
      RefuseValue("--tone", word, form);
    }
    if (pieces[0].rfind("reinhard", 0) != 0)
    {
      RefuseValue(
        "--tone", word, pieces[0] + " alone: only reinhard and reinhard-rgb have a white point");
    }
    choice.Parameters.emplace_back("white", pieces[i].substr(name.size()));
  }
}

//------------------------------------------------------------------------------
void TakeExposure(RenderOptions& options, const std::string& word)
{
  StageChoice& choice = AddStage(options.Stages, Stage, "--exposure");
  if (word == "auto")
  {
    choice.Parameters.emplace_back("auto_exposure", "on");
    return;
  }
  if (word.find_first_not_of("0123456789.eE+-") != std::string::npos)
  {
    RefuseValue("--exposure", word, "a number of stops from -20 to 20, or auto");
  }
  choice.Parameters.emplace_back("exposure", word);
}
}

//------------------------------------------------------------------------------
void AddToneOptions(OptionRows& rows, RenderOptions& all)
{
  vtkRelievoOption& tone =
    rows
      .Add("--tone", "OPERATOR[,white=W]",
        "how light above 1 is shown in the picture: neutral, clamp, simple, reinhard or "
        "reinhard-rgb; W is the light that reinhard and reinhard-rgb show as white (neutral, if "
        "--exposure is given). The EXR stores the colour before the operator",
        all, TakeTone)
      .NamedIn("Look", "Tone");
  tone.Sets = "tone";
  tone.Words = { "neutral", "clamp", "simple", "reinhard", "reinhard-rgb" };
  vtkRelievoOption& exposure =
    rows
      .Add("--exposure", "STOPS",
        "multiplies the light by 2 to this power, -20 to 20; auto: makes the mean of the "
        "drawn pixels a middle grey (0)",
        all, TakeExposure)
      .NamedIn("Look", "Exposure");
  exposure.Sets = "tone";
  exposure.Words = { "auto" };
}
}
