// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLayerMerge.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
constexpr int Tag = 46120;

// A process's description of a layer.
struct Kind
{
  int Type = VTK_VOID; // VTK_VOID: missing
  int Components = 0;
};

// Known properties of a layer without its image; of kind ARRAY if unknown.
const vtkRelievoLayer& Know(const std::string& name)
{
  // Names of lights are known only to the frame; all layers of lights have this prefix.
  return vtkRelievoLayerCatalogue::GetIsOfLight(name) ? vtkRelievoLayerCatalogue::GetOfLight()
                                                      : vtkRelievoLayerCatalogue::Find(name);
}

// The background value of a layer.
double GetNothing(const std::string& name, const Kind& kind)
{
  if (name == vtkPVRelievoLayerMerge::ProcessLayer)
  {
    return -1.0;
  }
  const vtkRelievoLayer& layer = Know(name);
  // An array of the data may be named like a layer of lights.
  const bool fits =
    !layer.OfLight || (kind.Type == layer.Type && kind.Components == layer.Components);
  const bool whole = kind.Type != VTK_FLOAT && kind.Type != VTK_DOUBLE;
  return layer.Kind != vtkRelievoLayer::ARRAY && fits ? layer.Background
    : whole                                           ? 0.0
                                                      : std::numeric_limits<double>::quiet_NaN();
}

Kind GetKnownKind(const std::string& name)
{
  if (name == vtkPVRelievoLayerMerge::ProcessLayer)
  {
    return { VTK_INT, 1 };
  }
  const vtkRelievoLayer& layer = Know(name);
  return layer.Kind != vtkRelievoLayer::ARRAY && layer.Source != vtkRelievoLayer::FROM_PICTURE
    ? Kind{ layer.Type, layer.Components }
    : Kind{};
}

// The image's array with the given kind: unchanged, converted, or created if missing.
void Complete(vtkImageData* image, const std::string& name, const Kind& kind)
{
  vtkDataArray* own = image->GetPointData()->GetArray(name.c_str());
  if (own && own->GetDataType() == kind.Type && own->GetNumberOfComponents() == kind.Components)
  {
    return;
  }
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(kind.Type));
  if (own && own->GetNumberOfComponents() == kind.Components)
  {
    array->DeepCopy(own);
  }
  else
  {
    array->SetNumberOfComponents(kind.Components);
    array->SetNumberOfTuples(image->GetNumberOfPoints());
    array->Fill(GetNothing(name, kind));
  }
  array->SetName(name.c_str());
  image->GetPointData()->AddArray(array);
}

std::vector<unsigned char*> GetBytes(
  vtkImageData* image, const std::vector<std::string>& names, std::vector<std::size_t>& sizes)
{
  std::vector<unsigned char*> bytes;
  sizes.clear();
  for (const std::string& name : names)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
    bytes.push_back(static_cast<unsigned char*>(array->GetVoidPointer(0)));
    sizes.push_back(static_cast<std::size_t>(array->GetDataTypeSize()) *
      static_cast<std::size_t>(array->GetNumberOfComponents()));
  }
  return bytes;
}

void Send(vtkMultiProcessController* controller, int to, const std::vector<std::string>& names,
  vtkImageData* image)
{
  std::vector<std::size_t> sizes;
  const auto bytes = GetBytes(image, names, sizes);
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    controller->Send(
      bytes[k], static_cast<vtkIdType>(sizes[k]) * image->GetNumberOfPoints(), to, Tag);
  }
}

// Copies the nearer pixels of another process: all of them if the image has none.
void Receive(vtkMultiProcessController* controller, int from, const std::vector<std::string>& names,
  bool hasOwn, vtkImageData* image)
{
  const vtkIdType count = image->GetNumberOfPoints();
  std::vector<std::size_t> sizes;
  const auto bytes = GetBytes(image, names, sizes);
  std::vector<unsigned char> nearer(static_cast<std::size_t>(count), 1);
  // Depth comes first, because it decides for the others.
  std::vector<unsigned char> other;
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    const std::size_t size = sizes[k];
    other.resize(size * static_cast<std::size_t>(count));
    controller->Receive(other.data(), static_cast<vtkIdType>(other.size()), from, Tag);
    if (k == 0 && hasOwn)
    {
      const auto* mine = reinterpret_cast<const float*>(bytes[0]);
      for (vtkIdType i = 0; i < count; ++i)
      {
        float theirs;
        std::memcpy(&theirs, &other[size * static_cast<std::size_t>(i)], sizeof(theirs));
        nearer[i] = theirs < mine[i] ? 1 : 0;
      }
    }
    for (std::size_t i = 0; i < nearer.size(); ++i)
    {
      if (nearer[i])
      {
        std::memcpy(bytes[k] + size * i, &other[size * i], size);
      }
    }
  }
}
// The combined description, equal on all processes.
struct Plan
{
  int Size[2] = { 0, 0 };         // 0: no process has an image
  std::vector<bool> Has;          // which processes have an image
  std::vector<std::string> Names; // of all layers, depth first
  std::vector<Kind> Kinds;        // of these layers
};

// Sends this process's description to the others, so that all decide alike. Returns an error, or
// "".
std::string Agree(vtkMultiProcessController* controller, vtkImageData* image,
  const std::vector<std::string>& names, Plan& plan)
{
  const int processes = controller->GetNumberOfProcesses();
  const int length = 2 + 2 * static_cast<int>(names.size());
  std::vector<int> mine = { image->GetDimensions()[0], image->GetDimensions()[1] };
  for (const std::string& name : names)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
    mine.push_back(array ? array->GetDataType() : VTK_VOID);
    mine.push_back(array ? array->GetNumberOfComponents() : 0);
  }
  std::vector<int> all(static_cast<std::size_t>(length) * processes);
  controller->AllGather(mine.data(), all.data(), length);

  std::vector<Kind> kinds(names.size());
  for (int process = 0; process < processes; ++process)
  {
    const int* said = &all[static_cast<std::size_t>(length) * process];
    plan.Has.push_back(said[0] > 0 && said[1] > 0);
    if (!plan.Has.back())
    {
      continue;
    }
    if (plan.Size[0] > 0 && (plan.Size[0] != said[0] || plan.Size[1] != said[1]))
    {
      return "process " + std::to_string(process) + " drew " + std::to_string(said[0]) + " x " +
        std::to_string(said[1]) + " pixels, another " + std::to_string(plan.Size[0]) + " x " +
        std::to_string(plan.Size[1]) + "; give all servers windows of one size";
    }
    std::copy_n(said, 2, plan.Size);
    for (std::size_t k = 0; k < names.size(); ++k)
    {
      const Kind kind{ said[2 + 2 * k], said[3 + 2 * k] };
      Kind& agreed = kinds[k];
      if (agreed.Type != VTK_VOID && kind.Type != VTK_VOID && agreed.Components != kind.Components)
      {
        return "'" + names[k] + "' has " + std::to_string(kind.Components) +
          " components on process " + std::to_string(process) + ", " +
          std::to_string(agreed.Components) + " on another; take an array that is alike everywhere";
      }
      if (agreed.Type == VTK_VOID)
      {
        agreed = kind;
      }
      else if (kind.Type != VTK_VOID && kind.Type != agreed.Type)
      {
        agreed.Type = VTK_DOUBLE;
      }
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    if (kinds[k].Type != VTK_VOID)
    {
      const bool depth = names[k] == "depth";
      plan.Names.insert(depth ? plan.Names.begin() : plan.Names.end(), names[k]);
      plan.Kinds.insert(depth ? plan.Kinds.begin() : plan.Kinds.end(), kinds[k]);
    }
  }
  return plan.Size[0] > 0 && (plan.Names.empty() || plan.Names.front() != "depth")
    ? "no process has the layer 'depth'"
    : std::string();
}
}

//------------------------------------------------------------------------------
std::string vtkPVRelievoLayerMerge::Merge(
  vtkMultiProcessController* controller, const std::vector<std::string>& names, vtkImageData* image)
{
  Plan plan;
  const std::string error = Agree(controller, image, names, plan);
  if (!error.empty() || plan.Size[0] == 0)
  {
    return error;
  }
  const int self = controller->GetLocalProcessId();
  auto complete = [&]() {
    for (std::size_t k = 0; k < plan.Names.size(); ++k)
    {
      Complete(image, plan.Names[k], plan.Kinds[k]);
    }
  };
  for (int step = 1; step < controller->GetNumberOfProcesses(); step *= 2)
  {
    for (int to = 0; to + step < controller->GetNumberOfProcesses(); to += 2 * step)
    {
      const int from = to + step;
      if (!plan.Has[from])
      {
        continue;
      }
      if (self == from)
      {
        complete();
        Send(controller, to, plan.Names, image);
      }
      else if (self == to)
      {
        if (!plan.Has[to])
        {
          image->Initialize();
          image->SetDimensions(plan.Size[0], plan.Size[1], 1);
        }
        complete();
        Receive(controller, from, plan.Names, plan.Has[to], image);
      }
      plan.Has[to] = true;
    }
  }
  if (self == 0)
  {
    complete(); // a single process with an image has converted nothing yet
  }
  else
  {
    image->Initialize();
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkPVRelievoLayerMerge::AddProcess(int process, vtkImageData* image)
{
  vtkDataArray* depth = image->GetPointData()->GetArray("depth");
  if (!depth)
  {
    return;
  }
  vtkNew<vtkIntArray> array;
  array->SetName(ProcessLayer);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    array->SetValue(i, std::isfinite(depth->GetComponent(i, 0)) ? process : -1);
  }
  image->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLayerMerge::FillBackground(
  const std::vector<std::string>& names, const int size[2], vtkImageData* image)
{
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(size[0], size[1], 1);
  }
  for (const std::string& name : names)
  {
    const Kind kind = GetKnownKind(name);
    if (kind.Type != VTK_VOID && !image->GetPointData()->HasArray(name.c_str()))
    {
      Complete(image, name, kind);
    }
  }
}
