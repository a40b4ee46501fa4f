// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Baseline.h"

#include "Errors.h"
#include "Messages.h"
#include "Numbers.h"
#include "Options.h"
#include "Scene.h"
#include "StyledScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkFieldData.h"
#include "vtkImageExtractComponents.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoBaseline.h"
#include "vtkRelievoImageFile.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"

#include <filesystem>
#include <string>
#include <vector>

namespace scene
{
namespace
{
// Records the camera's place, which is not fitted again, and the preset, which may come from the
// environment.
std::vector<std::string> GetWordsOf(
  vtkRenderer* renderer, const RenderOptions& options, Settings settings)
{
  settings.Files.clear();
  const CameraPlace place = GetPlace(renderer->GetActiveCamera());
  std::vector<double> numbers;
  for (const std::array<double, 3>& part : { place.Position, place.FocalPoint, place.ViewUp })
  {
    numbers.insert(numbers.end(), part.begin(), part.end());
  }
  settings.Set("--camera", WriteNumbers(numbers));
  settings.Set("--size", std::to_string(options.Size[0]) + "x" + std::to_string(options.Size[1]));
  settings.Set("--preset", options.Preset);
  if (options.Model.Time)
  {
    settings.Set("--time", WriteNumber(*options.Model.Time));
  }
  return settings.GetWords();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeBaseline(
  const StyledScene& styled, const RenderOptions& options, const Settings& settings, bool portable)
{
  vtkNew<vtkRelievoBaseline> baseline;
  baseline->SetPortable(portable);
  baseline->SetRenderer(styled.GetRenderer());
  for (const auto& [actor, name] : styled.GetObjectNames())
  {
    baseline->SetObjectName(actor, name);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  Messages::Check("the baseline", !baseline->Capture(image), "cannot be drawn");
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  for (const std::string& word : GetWordsOf(styled.GetRenderer(), options, settings))
  {
    words->InsertNextValue(word);
  }
  image->GetFieldData()->AddArray(words);
  return image;
}

//------------------------------------------------------------------------------
std::optional<Settings> GetRecorded(vtkImageData* baseline, const std::string& path)
{
  auto* record = vtkStringArray::SafeDownCast(baseline->GetFieldData()->GetAbstractArray("words"));
  if (!record)
  {
    return std::nullopt;
  }
  std::vector<std::string> words;
  for (vtkIdType i = 0; i < record->GetNumberOfValues(); ++i)
  {
    words.push_back(record->GetValue(i));
  }
  try
  {
    return Settings::FromWords(words);
  }
  catch (const UsageError& error) // a WorkError, because the command line is correct
  {
    throw WorkError(
      path + ": records options that cannot be read: " + error.what() + "; write it again");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakePicture(vtkImageData* frame)
{
  vtkNew<vtkImageData> picture;
  picture->ShallowCopy(frame);
  vtkPointData* data = picture->GetPointData();
  if (data->HasArray("color"))
  {
    data->SetActiveScalars("color");
  }
  else if (data->HasArray("depth") || data->HasArray("actor"))
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkImageData> bytes = vtkRelievoImageFile::ToColors(picture);
  vtkNew<vtkImageExtractComponents> colors;
  colors->SetInputData(bytes);
  bytes->GetNumberOfScalarComponents() < 3 ? colors->SetComponents(0)
                                           : colors->SetComponents(0, 1, 2);
  colors->Update();
  return colors->GetOutput();
}
}
