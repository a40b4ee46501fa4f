// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf.h"

#include "CrashGuard.h"
#include "Errors.h"
#include "Messages.h"
#include "Progress.h"

#include "vtkActor.h"
#include "vtkGLTFDocumentLoader.h"
#include "vtkGLTFImporter.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace scene
{
namespace
{
using Loader = vtkGLTFDocumentLoader;

// The text of the file, or of the first chunk of a .glb.
std::string ReadJSON(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  char head[20] = {};
  if (!file.read(head, sizeof head) || std::memcmp(head, "glTF", 4) != 0)
  {
    file.clear();
    file.seekg(0);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }
  std::uint32_t length = 0;
  std::memcpy(&length, head + 12, sizeof length);
  std::error_code unknown;
  std::string text(
    std::min<std::uintmax_t>(length, std::filesystem::file_size(path, unknown)), ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

// %20 and its like are single characters.
std::string Decode(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() &&
      std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
      std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    text += coded ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    i += coded ? 2 : 0;
  }
  return text;
}

//------------------------------------------------------------------------------
// VTK crashes without a buffer, and draws nothing without an image.
void CheckNamedFiles(const std::string& path)
{
  const nlohmann::json model = nlohmann::json::parse(ReadJSON(path), nullptr, false);
  for (const char* list : { "buffers", "images" })
  {
    const auto found = model.is_object() ? model.find(list) : model.end();
    if (found == model.end() || !found->is_array())
    {
      continue;
    }
    for (const auto& each : *found)
    {
      const auto uri = each.is_object() ? each.find("uri") : each.end();
      if (uri == each.end() || !uri->is_string())
      {
        continue;
      }
      const auto& coded = uri->get_ref<const std::string&>();
      std::error_code unknown;
      if (coded.rfind("data:", 0) != 0 &&
        !std::filesystem::exists(
          std::filesystem::path(path).parent_path() / Decode(coded), unknown))
      {
        throw WorkError(path + ": names " + Decode(coded) + ", which is not there");
      }
    }
  }
}

//------------------------------------------------------------------------------
// That of the base colour where it is to be blended; of what a mask cuts away, 0.
double GetOpacity(const Loader::Material& material)
{
  using Mode = Loader::Material::AlphaModeType;
  const std::vector<double>& color = material.PbrMetallicRoughness.BaseColorFactor;
  if (color.size() < 4 || material.AlphaMode == Mode::OPAQUE)
  {
    return 1.0;
  }
  const bool textured = material.PbrMetallicRoughness.BaseColorTexture.Index >= 0;
  return material.AlphaMode == Mode::BLEND         ? color[3]
    : !textured && color[3] < material.AlphaCutoff ? 0.0
                                                   : 1.0;
}

bool GlowsAlone(const Loader::Material& material)
{
  const std::vector<double>& glow = material.EmissiveFactor;
  return material.EmissiveTexture.Index < 0 &&
    std::any_of(glow.begin(), glow.end(), [](double share) { return share > 0.0; });
}

// The primitives' opacities in the order in which the importer makes their actors.
std::vector<double> ListOpacities(const Loader::Model& model)
{
  std::vector<double> opacities;
  std::vector<unsigned int> nodes;
  if (model.DefaultScene >= 0 && model.DefaultScene < static_cast<int>(model.Scenes.size()))
  {
    nodes = model.Scenes[static_cast<std::size_t>(model.DefaultScene)].Nodes;
  }
  for (std::size_t visited = 0; !nodes.empty() && visited <= model.Nodes.size(); ++visited)
  {
    const Loader::Node& node = model.Nodes.at(nodes.back());
    nodes.pop_back();
    if (node.Mesh >= 0)
    {
      for (const Loader::Primitive& primitive :
        model.Meshes.at(static_cast<std::size_t>(node.Mesh)).Primitives)
      {
        const int material = primitive.Material;
        opacities.push_back(material >= 0 && material < static_cast<int>(model.Materials.size())
            ? GetOpacity(model.Materials[static_cast<std::size_t>(material)])
            : 1.0);
      }
    }
    nodes.insert(nodes.end(), node.Children.begin(), node.Children.end());
  }
  return opacities;
}
}

//------------------------------------------------------------------------------
void ImportGLTF(const std::string& path, vtkRenderWindow* window, Progress& progress)
{
  progress.Begin("reading " + path);
  CheckNamedFiles(path);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetRenderWindow(window);
  progress.Observe(importer);
  try
  {
    const CrashGuard guard(path);
    importer->Update();
  }
  catch (const std::exception& error) // of the JSON library that VTK reads glTF with
  {
    throw WorkError(path + ": " + error.what());
  }
  progress.End();
  Messages::Check(path);
}

//------------------------------------------------------------------------------
std::map<vtkActor*, double> ReadOpacities(
  const std::string& path, const std::vector<vtkActor*>& actors)
{
  std::map<vtkActor*, double> found;
  try
  {
    vtkNew<Loader> loader;
    if (!loader->LoadModelMetaDataFromFile(path))
    {
      return found;
    }
    const Loader::Model& model = *loader->GetInternalModel();
    const std::vector<double> opacities = ListOpacities(model);
    for (std::size_t i = 0; opacities.size() == actors.size() && i < actors.size(); ++i)
    {
      found[actors[i]] = opacities[i];
    }
    if (std::any_of(model.Materials.begin(), model.Materials.end(), GlowsAlone))
    {
      Messages::Note(
        path + ": light that a material gives off by itself, without a texture, is not drawn");
    }
  }
  catch (const std::exception&) // the importer has said what there is to say
  {
    found.clear();
  }
  return found;
}
}
