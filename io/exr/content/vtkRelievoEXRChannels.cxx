// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRChannels.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

namespace relievo::exr
{
namespace
{
struct TypeName
{
  int VtkType;
  const char* Name;
  bool Integer;
};

// The names are part of the file format: never change one.
const std::array<TypeName, 14> TypeNames = { {
  { VTK_FLOAT, "float", false },
  { VTK_DOUBLE, "double", false },
  { VTK_CHAR, "char", true },
  { VTK_SIGNED_CHAR, "schar", true },
  { VTK_UNSIGNED_CHAR, "uchar", true },
  { VTK_SHORT, "short", true },
  { VTK_UNSIGNED_SHORT, "ushort", true },
  { VTK_INT, "int", true },
  { VTK_UNSIGNED_INT, "uint", true },
  { VTK_LONG, "long", true },
  { VTK_UNSIGNED_LONG, "ulong", true },
  { VTK_LONG_LONG, "longlong", true },
  { VTK_UNSIGNED_LONG_LONG, "ulonglong", true },
  { VTK_ID_TYPE, "idtype", true },
} };

std::vector<std::string> Split(const std::string& suffixes)
{
  std::vector<std::string> out;
  std::istringstream words(suffixes);
  for (std::string word; std::getline(words, word, ',');)
  {
    out.push_back(word);
  }
  return out;
}

// The suffixes of the layer with this name, number of components and kind of numbers; empty if
// there is none.
std::vector<std::string> LayerSuffixes(const std::string& array, int components, bool integer)
{
  const vtkRelievoLayer& layer = vtkRelievoLayerCatalogue::Find(array);
  const bool fits = layer.Kind == vtkRelievoLayer::COLOR ? components == 3 || components == 4
                                                         : layer.Kind != vtkRelievoLayer::ARRAY &&
      components == layer.Components && (layer.Kind != vtkRelievoLayer::ID || integer);
  return fits ? Split(layer.Suffixes) : std::vector<std::string>();
}

// The picture's channels have no prefix: every program looks for R, G and B.
std::string ChannelPrefix(const std::string& array)
{
  return array == vtkRelievoLayerCatalogue::GetPicture().Name ? std::string() : array + ".";
}

// Groups channels without a record; see the table in the header.
class Grouping
{
public:
  Grouping(
    const std::vector<NamedChannel>& channels, std::vector<bool> taken, std::set<std::string> names)
    : Channels(channels)
    , Taken(std::move(taken))
    , Names(std::move(names))
  {
    for (int i = 0; i < static_cast<int>(channels.size()); ++i)
    {
      if (!this->Taken[i])
      {
        this->Index[channels[i].Name] = i;
      }
    }
  }

  std::vector<ArrayLayout> Run()
  {
    const vtkRelievoLayer& picture = vtkRelievoLayerCatalogue::GetPicture();
    this->TryGroup(picture.Name, "", Split(picture.Suffixes), 3);
    for (const NamedChannel& channel : this->Channels)
    {
      const std::size_t dot = channel.Name.rfind('.');
      if (dot == std::string::npos || dot == 0)
      {
        continue;
      }
      const std::string layer = channel.Name.substr(0, dot);
      const std::string prefix = layer + ".";
      const std::vector<std::string> suffixes = LayerSuffixes(layer, 1, channel.Integer);
      if (!suffixes.empty() && suffixes.front() != "V") // any array may have V, handled below
      {
        const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::Find(layer);
        const bool id = known.Kind == vtkRelievoLayer::ID;
        this->TryGroup(layer, prefix, suffixes, 1, id ? known.Type : VTK_VOID);
      }
      this->TryGroup(layer, prefix, { "R", "G", "B", "A" }, 3);
      this->TryGroup(layer, prefix, { "X", "Y", "Z" }, 2);
      this->TryGroup(layer, prefix, { "V" }, 1);
      this->TryNumbered(layer, prefix);
    }
    for (int i = 0; i < static_cast<int>(this->Channels.size()); ++i)
    {
      if (!this->Taken[i])
      {
        this->Add(this->Channels[i].Name, { i }, VTK_VOID);
      }
    }
    return std::move(this->Layouts);
  }

private:
  const std::vector<NamedChannel>& Channels;
  std::vector<bool> Taken;
  std::set<std::string> Names; // of the arrays made so far
  std::map<std::string, int> Index;
  std::vector<ArrayLayout> Layouts;

  int Find(const std::string& name) const
  {
    const auto found = this->Index.find(name);
    return found == this->Index.end() || this->Taken[found->second] ? -1 : found->second;
  }

  // Makes an array of prefix + suffix for the leading suffixes present, if at least `least` are.
  void TryGroup(const std::string& array, const std::string& prefix,
    const std::vector<std::string>& suffixes, std::size_t least, int vtkType = VTK_VOID)
  {
    // A channel of exactly this name will be a separate array.
    if (this->Names.count(array) > 0 || this->Index.count(array) > 0)
    {
      return;
    }
    std::vector<int> found;
    for (const std::string& suffix : suffixes)
    {
      const int channel = this->Find(prefix + suffix);
      const bool alike = channel >= 0 &&
        (found.empty() || this->Channels[channel].Integer == this->Channels[found[0]].Integer);
      if (!alike)
      {
        break;
      }
      found.push_back(channel);
    }
    if (found.size() >= least)
    {
      this->Add(array, found, vtkType);
    }
  }

  void TryNumbered(const std::string& layer, const std::string& prefix)
  {
    std::vector<std::string> suffixes;
    if (this->Names.count(layer) > 0 || this->Index.count(layer) > 0)
    {
      return;
    }
    while (this->Find(prefix + std::to_string(suffixes.size())) >= 0)
    {
      suffixes.push_back(std::to_string(suffixes.size()));
    }
    this->TryGroup(layer, prefix, suffixes, 4);
  }

  void Add(const std::string& array, const std::vector<int>& channels, int vtkType)
  {
    if (vtkType == VTK_VOID)
    {
      vtkType = this->Channels[channels[0]].Integer ? VTK_UNSIGNED_INT : VTK_FLOAT;
    }
    std::string name = array;
    for (int copy = 2; !this->Names.insert(name).second; ++copy)
    {
      name = array + "_" + std::to_string(copy);
    }
    for (const int channel : channels)
    {
      this->Taken[channel] = true;
    }
    this->Layouts.push_back({ name, vtkType, channels });
  }
};
}

//------------------------------------------------------------------------------
std::string ChannelName(const std::string& array, int components, bool integer, int component)
{
  const std::vector<std::string> suffixes = LayerSuffixes(array, components, integer);
  if (!suffixes.empty())
  {
    return ChannelPrefix(array) + suffixes[component];
  }
  static const char* const xyz[] = { "X", "Y", "Z" };
  return array + "." +
    (components == 1      ? "V"
        : components <= 3 ? xyz[component]
                          : std::to_string(component));
}

//------------------------------------------------------------------------------
bool IsNormalized(const std::string& array, int vtkType, int components)
{
  return vtkType == VTK_UNSIGNED_CHAR && (components == 3 || components == 4) &&
    vtkRelievoLayerCatalogue::Find(array).Kind == vtkRelievoLayer::COLOR;
}

//------------------------------------------------------------------------------
bool IsPosition(const std::string& array, int vtkType, int components)
{
  return components == 3 && (vtkType == VTK_FLOAT || vtkType == VTK_DOUBLE) &&
    vtkRelievoLayerCatalogue::Find(array).Kind == vtkRelievoLayer::POSITION;
}

//------------------------------------------------------------------------------
vtkDataArray* FindPositions(vtkPointData* points)
{
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    const char* name = array ? array->GetName() : nullptr;
    if (name && IsPosition(name, array->GetDataType(), array->GetNumberOfComponents()))
    {
      return array;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string RecordEntry(const std::string& array, int vtkType, int components)
{
  for (const TypeName& type : TypeNames)
  {
    if (type.VtkType == vtkType)
    {
      return std::string(type.Name) + " " + std::to_string(components) + " " + array;
    }
  }
  return std::string();
}

//------------------------------------------------------------------------------
std::vector<ArrayLayout> GroupChannels(
  const std::vector<NamedChannel>& channels, const std::vector<std::string>& record)
{
  std::map<std::string, int> index;
  for (int i = 0; i < static_cast<int>(channels.size()); ++i)
  {
    index[channels[i].Name] = i;
  }

  std::vector<ArrayLayout> layouts;
  std::vector<bool> taken(channels.size(), false);
  std::set<std::string> names;
  for (const std::string& entry : record)
  {
    std::istringstream words(entry);
    std::string typeName;
    int components = 0;
    std::string name;
    words >> typeName >> components;
    words.get(); // the blank before the name, which may contain blanks
    std::getline(words, name, '\0');
    const auto type = std::find_if(TypeNames.begin(), TypeNames.end(),
      [&](const TypeName& known) { return typeName == known.Name; });
    if (type == TypeNames.end() || name.empty() || components < 1 ||
      components > static_cast<int>(channels.size()) || names.count(name) > 0)
    {
      continue;
    }
    ArrayLayout layout{ name, type->VtkType, {} };
    for (int i = 0; i < components; ++i)
    {
      const auto found = index.find(ChannelName(name, components, type->Integer, i));
      // Integers may be stored as FLOAT or HALF at the user's request, but never floats as UINT.
      if (found == index.end() || taken[found->second] ||
        (channels[found->second].Integer && !type->Integer))
      {
        break;
      }
      layout.Channels.push_back(found->second);
    }
    if (static_cast<int>(layout.Channels.size()) == components)
    {
      for (const int channel : layout.Channels)
      {
        taken[channel] = true;
      }
      names.insert(name);
      layouts.push_back(layout);
    }
  }

  std::vector<ArrayLayout> rest = Grouping(channels, taken, names).Run();
  layouts.insert(layouts.end(), rest.begin(), rest.end());
  return layouts;
}
}
