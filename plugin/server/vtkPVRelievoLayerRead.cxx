// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLayerRead.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoPass.h"

#include <algorithm>

namespace
{
// Keeps what an object has to say instead of printing it.
class Listener
{
public:
  explicit Listener(vtkObject* object)
    : Object(object)
    , Tag(object->AddObserver(vtkCommand::ErrorEvent, this, &Listener::Hear))
  {
  }
  ~Listener() { this->Object->RemoveObserver(this->Tag); }
  Listener(const Listener&) = delete;
  void operator=(const Listener&) = delete;

  std::string Heard;

private:
  void Hear(vtkObject*, unsigned long, void* text)
  {
    // Without the place in the source and the object's address, which come first.
    const std::string all = static_cast<const char*>(text);
    const std::size_t begin = all.find("): ");
    const std::string words = begin == std::string::npos ? all : all.substr(begin + 3);
    this->Heard = words.substr(0, words.find_last_not_of(" .\n") + 1);
  }

  vtkObject* Object;
  unsigned long Tag;
};
}

//------------------------------------------------------------------------------
std::string vtkPVRelievoLayerRead::ReadSome(
  vtkRelievoPass* frame, const std::vector<std::string>& names, vtkImageData* image)
{
  std::string first;
  auto next = names.begin();
  while (next != names.end())
  {
    const std::vector<std::string> rest(next, names.end());
    Listener errors(frame->GetGBuffer());
    if (frame->ReadLayers(rest, image))
    {
      break;
    }
    first = first.empty() ? errors.Heard : first;
    next = std::find_if(next, names.end(),
      [&](const std::string& name) { return !image->GetPointData()->HasArray(name.c_str()); });
    next += next != names.end() ? 1 : 0;
  }
  return first;
}
