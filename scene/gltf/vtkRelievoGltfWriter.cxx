// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfWriter.h"

#include "GltfBuffer.h"
#include "GltfCheck.h"
#include "GltfLights.h"
#include "GltfMaterials.h"
#include "GltfMeshes.h"
#include "GltfShape.h"
#include "GltfSurface.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkDataSet.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoPropParts.h"
#include "vtkRelievoTemporaryFile.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

vtkStandardNewMacro(vtkRelievoGltfWriter);

namespace
{
using scene::GltfBuffer;
using Json = GltfBuffer::Json;

// The turn that makes an axis y.
glm::dmat4 MakeUpright(int axis)
{
  const glm::dvec4 x(1., 0., 0., 0.);
  const glm::dvec4 y(0., 1., 0., 0.);
  const glm::dvec4 z(0., 0., 1., 0.);
  const glm::dvec4 w(0., 0., 0., 1.);
  return axis == 0 ? glm::dmat4(y, -x, z, w) : axis == 2 ? glm::dmat4(x, -z, y, w) : glm::dmat4(1.);
}

// Writes all bytes; otherwise returns the operating system's error.
int WriteBytes(const std::string& path, const std::vector<unsigned char>& bytes)
{
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file)
  {
    return errno != 0 ? errno : EIO;
  }
  const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int trouble = isWritten ? 0 : errno;
  const bool isClosed = std::fclose(file) == 0;
  return isWritten && isClosed ? 0 : trouble != 0 ? trouble : errno != 0 ? errno : EIO;
}

// The file's contents, and notes about parts that it leaves out.
struct Contents
{
  GltfBuffer Buffer;
  std::set<std::string> Notes;
  std::set<std::size_t> Linear;  // materials of surfaces with linear colours
  std::vector<vtkActor*> Actors; // of each primitive
  std::set<vtkActor*> Partial;   // actors that the file has in part only, or not at all
};

// A surface of the scene, with the name of its actor.
struct Drawn
{
  scene::GltfSurface Surface;
  std::string Name;
};

// Keeps the level of detail that has the most cells.
void KeepFinest(std::vector<vtkRelievoPropParts::Part>& parts)
{
  const auto count = [](const vtkRelievoPropParts::Part& part) {
    vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    auto* data = vtkDataSet::SafeDownCast(mapper ? mapper->GetInputDataObject(0, 0) : nullptr);
    return data ? data->GetNumberOfCells() : vtkIdType(0);
  };
  const auto finest = std::max_element(
    parts.begin(), parts.end(), [&](const auto& a, const auto& b) { return count(a) < count(b); });
  if (finest != parts.end())
  {
    parts = { *finest };
  }
}

std::map<vtkActor*, std::string> FindNames(
  vtkRenderer* renderer, const std::map<int, std::string>& names)
{
  std::map<vtkActor*, std::string> found;
  vtkActorCollection* actors = renderer->GetActors();
  for (const auto& [number, name] : names)
  {
    if (number >= 0 && number < actors->GetNumberOfItems())
    {
      found[static_cast<vtkActor*>(actors->GetItemAsObject(number))] = name;
    }
  }
  return found;
}

std::vector<Drawn> CollectDrawn(vtkRenderer* renderer, const std::map<int, std::string>& numbered,
  vtkRelievoGlyphPlaces& glyphs, Contents& contents)
{
  const std::map<vtkActor*, std::string> names = FindNames(renderer, numbered);
  std::vector<Drawn> drawn;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    std::vector<vtkRelievoPropParts::Part> parts;
    vtkRelievoPropParts::Collect(prop, parts);
    if (vtkLODProp3D::SafeDownCast(prop))
    {
      KeepFinest(parts);
    }
    for (const vtkRelievoPropParts::Part& part : parts)
    {
      if (vtkVolume::SafeDownCast(part.Prop))
      {
        contents.Notes.insert("volumes are left out: glTF has none");
      }
      vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
      if (!actor || !actor->GetVisibility() || vtkRelievoPropParts::IsAnnotation(actor))
      {
        continue;
      }
      const auto named = names.find(actor);
      const std::string name = named == names.end() ? "" : named->second;
      std::vector<scene::GltfSurface> surfaces;
      const std::string trouble = scene::CollectSurfaces(actor, part.Matrix, glyphs, surfaces);
      if (!trouble.empty())
      {
        contents.Notes.insert((name.empty() ? "an actor" : name) + " is left out: " + trouble);
        contents.Partial.insert(actor);
      }
      for (const scene::GltfSurface& surface : surfaces)
      {
        drawn.push_back({ surface, name });
      }
    }
  }
  return drawn;
}

Contents MakeContents(vtkRenderer* renderer, const glm::dmat4& upright,
  const std::map<int, std::string>& names, const std::vector<scene::GltfKey>& keys)
{
  Contents contents;
  GltfBuffer& buffer = contents.Buffer;
  buffer.Document["asset"] = { { "version", "2.0" },
    { "generator", std::string("Relievo ") + RELIEVO_VERSION } };
  std::vector<double> times;
  std::vector<scene::GltfPlace> cameras;
  for (const scene::GltfKey& key : keys)
  {
    times.push_back(key.Seconds);
    cameras.push_back(key.Camera);
  }
  scene::GltfMaterials materials(buffer, contents.Notes);
  scene::GltfMeshes meshes(buffer, materials, contents.Notes, times);
  vtkRelievoGlyphPlaces glyphs(vtkRelievoGlyphPlaces::Numbers::Exact);
  std::vector<std::size_t> roots;
  bool isPBR = false;
  for (const Drawn& one : CollectDrawn(renderer, names, glyphs, contents))
  {
    std::vector<const scene::GltfShape*> moments;
    for (const scene::GltfKey& key : keys)
    {
      const auto found = key.Shapes.find({ one.Surface.Actor, one.Surface.Number });
      moments.push_back(found == key.Shapes.end() ? nullptr : &found->second);
    }
    const scene::GltfShape shape(one.Surface);
    if (const auto node = meshes.Add(one.Surface, shape, one.Name, moments))
    {
      roots.push_back(*node);
      contents.Actors.insert(contents.Actors.end(), shape.Primitives.size(), one.Surface.Actor);
      isPBR = isPBR || scene::HasLinearColors(one.Surface);
    }
  }
  contents.Linear = materials.GetLinear();
  contents.Partial.insert(materials.GetPartial().begin(), materials.GetPartial().end());
  if (renderer->GetUseImageBasedLighting())
  {
    contents.Notes.insert("the environment is left out: glTF has none");
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 center(
    (bounds[0] + bounds[1]) / 2., (bounds[2] + bounds[3]) / 2., (bounds[4] + bounds[5]) / 2.);
  for (const std::size_t node : scene::AddLights(buffer, renderer, center, isPBR, contents.Notes))
  {
    roots.push_back(node);
  }
  roots.push_back(scene::AddCamera(buffer, renderer));
  if (!cameras.empty())
  {
    meshes.Move(roots.back(), cameras);
  }
  meshes.Finish();
  if (upright != glm::dmat4(1.))
  {
    Json turned = scene::GltfPlace::Find(upright)->GetNode("up");
    turned["children"] = roots;
    roots = { buffer.Append("nodes", std::move(turned)) };
  }
  buffer.Document["scenes"] = Json::array({ { { "nodes", roots } } });
  buffer.Document["scene"] = 0;
  return contents;
}

// The file at rest, with surfaces unlit that are not PBR in the scene: it shows their colours
// unchanged.
std::vector<unsigned char> MakeUnlit(const Contents& contents)
{
  GltfBuffer buffer = contents.Buffer;
  buffer.Use("KHR_materials_unlit");
  buffer.Document.erase("animations");
  Json& materials = buffer.Document["materials"];
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    if (contents.Linear.count(i) == 0)
    {
      materials[i]["extensions"]["KHR_materials_unlit"] = Json::object();
    }
  }
  return buffer.GetFile();
}
}

//------------------------------------------------------------------------------
class vtkRelievoGltfWriter::Internals
{
public:
  std::vector<scene::GltfKey> Keys;
};

//------------------------------------------------------------------------------
vtkRelievoGltfWriter::vtkRelievoGltfWriter()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkRelievoGltfWriter::~vtkRelievoGltfWriter() = default;

//------------------------------------------------------------------------------
void vtkRelievoGltfWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "UpAxis: " << this->UpAxis << "\n";
  os << indent << "Check: " << this->Check << "\n";
  os << indent << "Names: " << this->Names.size() << "\n";
  os << indent << "Keys: " << this->Internal->Keys.size() << "\n";
  os << indent << "Notes: " << this->Notes.size() << "\n";
  os << indent << "SystemError: " << this->SystemError << "\n";
}

//------------------------------------------------------------------------------
void vtkRelievoGltfWriter::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoGltfWriter::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkRelievoGltfWriter::SetFileName(RELIEVO_TEXT name)
{
  this->FileName = name;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoGltfWriter::SetObjectName(int actor, RELIEVO_TEXT name)
{
  this->Names[actor] = name;
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoGltfWriter::GetObjectName(int actor)
{
  const auto found = this->Names.find(actor);
  return found == this->Names.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
std::string vtkRelievoGltfWriter::GetNote(int i)
{
  return i >= 0 && i < this->GetNumberOfNotes() ? this->Notes[static_cast<std::size_t>(i)] : "";
}

//------------------------------------------------------------------------------
bool vtkRelievoGltfWriter::AddKey(double seconds)
{
  std::vector<scene::GltfKey>& keys = this->Internal->Keys;
  if (!this->Renderer || !std::isfinite(seconds) ||
    (!keys.empty() && !(seconds > keys.back().Seconds)))
  {
    vtkErrorMacro("AddKey was given "
      << seconds
      << " seconds; give it a renderer with SetRenderer, and a time "
         "later than those before.");
    return false;
  }
  scene::GltfKey key;
  key.Seconds = seconds;
  key.Camera = scene::GetCameraPlace(this->Renderer);
  Contents unused; // its notes are those of Write()
  vtkRelievoGlyphPlaces glyphs(vtkRelievoGlyphPlaces::Numbers::Exact);
  for (const Drawn& one : CollectDrawn(this->Renderer, this->Names, glyphs, unused))
  {
    key.Shapes.emplace(
      std::make_pair(one.Surface.Actor, one.Surface.Number), scene::GltfShape(one.Surface));
  }
  keys.push_back(std::move(key));
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoGltfWriter::RemoveAllKeys()
{
  this->Internal->Keys.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoGltfWriter::Write()
{
  this->Notes.clear();
  this->SystemError = 0;
  if (!this->Renderer || !this->Renderer->GetRenderWindow() || this->FileName.empty())
  {
    vtkErrorMacro("Write needs a renderer in a render window, and a file name; set them with "
                  "SetRenderer and SetFileName.");
    return false;
  }
  this->Renderer->GetRenderWindow()->Render(); // places lights that follow the camera
  const glm::dmat4 upright = MakeUpright(this->UpAxis);
  const Contents contents =
    MakeContents(this->Renderer, upright, this->Names, this->Internal->Keys);
  this->Notes.assign(contents.Notes.begin(), contents.Notes.end());
  if (contents.Actors.empty())
  {
    vtkErrorMacro(
      "Cannot write '" << this->FileName << "': the renderer shows no mesh that glTF can hold.");
    return false;
  }
  const std::string folder = std::filesystem::path(this->FileName).parent_path().string();
  const auto make = [&](const std::vector<unsigned char>& from, auto&& use) {
    std::error_code trouble;
    vtkRelievoTemporaryFile file(folder.empty() ? "." : folder, trouble, ".glb"); // for the reader
    this->SystemError = trouble ? trouble.value() : WriteBytes(file.GetName(), from);
    if (this->SystemError == 0)
    {
      use(file);
    }
  };
  std::string difference;
  if (this->Check)
  {
    make(MakeUnlit(contents), [&](vtkRelievoTemporaryFile& file) {
      difference = scene::FindDifference(
        this->Renderer, file.GetName(), upright, contents.Actors, contents.Partial);
    });
  }
  const std::vector<unsigned char> bytes =
    difference.empty() ? contents.Buffer.GetFile() : std::vector<unsigned char>();
  if (difference.empty() && bytes.empty())
  {
    vtkErrorMacro("Cannot write '" << this->FileName
                                   << "': it would exceed the 4 GiB of a .glb file; show less.");
    return false;
  }
  if (this->SystemError == 0 && difference.empty())
  {
    make(bytes, [&](vtkRelievoTemporaryFile& file) {
      std::error_code trouble;
      file.MoveTo(this->FileName, trouble);
      this->SystemError = trouble.value();
    });
  }
  if (this->SystemError != 0)
  {
    vtkErrorMacro("Cannot write '"
      << this->FileName << "': " << std::generic_category().message(this->SystemError) << ".");
  }
  else if (!difference.empty())
  {
    std::string left;
    for (const std::string& note : this->Notes)
    {
      left += "; " + note;
    }
    vtkErrorMacro(
      "The glTF of '" << this->FileName << "' " << difference << " and is not kept" << left << ".");
  }
  return this->SystemError == 0 && difference.empty();
}
