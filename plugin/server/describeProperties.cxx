// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// describeProperties TEMPLATE OUTPUT: writes the XML of ParaView's proxies, with properties
// generated from the descriptions of stages, points, materials, environments and filters, and lists
// of layers from the catalogue. Run by the build.
//
// A comment on a line of its own in the template is replaced: `points` by the proxies of surfaces'
// points for every stage of points; `stages: properties` by the properties of every stage with a
// switch, and `stages: exposed` by their groups in the render view; likewise `shadows`, `sun`,
// `display`, `environment`, `selection` and `material`, which have groups of their own; `caves:
// properties` and the like by those of filters; `layers` by the names of layers; `layers: shown` by
// those that can be shown as the picture. Within other lines, @layers: help@ is replaced by a
// description of the layers, @layers: count@ by the number of values in a selection of layers, and
// @layers: A B@ by the values of a selection of A and B, A first; @images@ and @models@ by the
// extensions of their files. The templates themselves have inputs, files, switches that only the
// view has, and lists.
#include "vtkNew.h"
#include "vtkPVRelievoSun.h"
#include "vtkPVRelievoVisibility.h"
#include "vtkRelievoBoneWeights.h"
#include "vtkRelievoCaves.h"
#include "vtkRelievoCover.h"
#include "vtkRelievoDepthToPoints.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentConvert.h"
#include "vtkRelievoEnvironmentIrradiance.h"
#include "vtkRelievoEnvironmentPrefilter.h"
#include "vtkRelievoHeightsToNormals.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoMarkers.h"
#include "vtkRelievoMaterial.h"
#include "vtkRelievoModelReader.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoSkin.h"
#include "vtkRelievoSmoothBlocks.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoSunExposure.h"
#include "vtkRelievoSurfaceParticles.h"
#include "vtkRelievoTangents.h"
#include "vtkRelievoTextureCoordinates.h"
#include "vtkRelievoViewFactors.h"
#include "vtkRelievoViewshed.h"
#include "vtkRelievoVoxelCubes.h"
#include "vtkRelievoVoxelShell.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
std::string Escape(const std::string& text)
{
  std::string out;
  for (char c : text)
  {
    out += c == '&' ? "&amp;"
      : c == '<'    ? "&lt;"
      : c == '>'    ? "&gt;"
      : c == '"'    ? "&quot;"
                    : std::string(1, c);
  }
  return out;
}

// The parameter's present value in a new object, formatted for XML.
std::string FormatDefault(const vtkRelievoParameter& parameter)
{
  using P = vtkRelievoParameter;
  std::string words = parameter.Format();
  if (parameter.Type == P::FLAG || parameter.Type == P::CHOICE)
  {
    words = std::to_string(parameter.FirstChoice + static_cast<int>(parameter.GetValues()[0]));
  }
  else if (parameter.Type == P::DATE)
  {
    std::replace(words.begin(), words.end(), '-', ' ');
  }
  else if (parameter.Type != P::TEXT)
  {
    std::replace_if(
      words.begin(), words.end(), [](char c) { return c == ',' || c == 'x'; }, ' ');
  }
  return Escape(words);
}

// Turns "blue noise" into "Blue Noise", and for filters into "Blue noise", the name in existing
// scripts. Labels with a capital stay.
std::string WriteChoice(const std::string& label, bool ofFilter)
{
  if (std::any_of(label.begin(), label.end(), [](char c) { return c >= 'A' && c <= 'Z'; }))
  {
    return label;
  }
  if (ofFilter)
  {
    return vtkRelievoCapitalize(label, true);
  }
  std::string words = label;
  std::replace(words.begin(), words.end(), ' ', '_');
  return label == "vtk" ? "VTK" : vtkRelievoCapitalize(words, true);
}

std::string Documentation(const std::string& help)
{
  return "        <Documentation>" + Escape(help) + "</Documentation>\n";
}

// An owner of parameters, and the form of its properties in a proxy. Every name is a file format:
// state files and scripts contain it.
struct Described
{
  const vtkRelievoParameterList& List;
  std::string Command;   // of the proxy's object; empty: the parameter's own method
  std::string Owner;     // the command's argument before the parameter's name
  std::string Prefix;    // of the properties' names in the proxy
  std::string Exposed;   // prefix of the exposed names for scripts
  std::string Shown;     // the decorator that hides properties without effect
  bool Verbatim = false; // choices have their names

  std::string GetName(const std::string& parameter) const
  {
    // Avoids the word Shadows twice in "Colored Shadows" of shadows.
    const std::string again = "_shadows";
    const std::size_t at = this->Owner == "shadows:" ? parameter.rfind(again) : std::string::npos;
    return this->Prefix + vtkRelievoCapitalize(parameter.substr(0, at), false);
  }
  std::string GetExposedName(const std::string& parameter) const
  {
    return this->Exposed + this->GetName(parameter);
  }
};

std::string Decorate(const std::string& property, const std::string& value, bool other)
{
  return "          <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\" "
         "property=\"" +
    property + "\" value=\"" + value + (other ? "\" inverse=\"1\"/>\n" : "\"/>\n");
}

std::string DecorateIf(const Described& described, const vtkRelievoParameter::Condition& condition)
{
  if (condition.Name == "enabled") // the stage's switch
  {
    return Decorate(described.Exposed + described.Prefix, "1", false);
  }
  if (const vtkRelievoParameter* other = described.List.Find(condition.Name))
  {
    std::string value = condition.Value;
    if (other->Type == vtkRelievoParameter::FLAG)
    {
      value = value == "on" ? "1" : "0";
    }
    else if (!other->Choices.empty())
    {
      const auto place = std::find(other->Choices.begin(), other->Choices.end(), value);
      value = std::to_string(other->FirstChoice + (place - other->Choices.begin()));
    }
    return Decorate(described.GetExposedName(condition.Name), value, condition.Other);
  }
  const bool given = condition.Value.empty();
  return condition.Name == "environment"
    ? Decorate("RelievoMirror", "1", false)
    : Decorate(described.GetExposedName(condition.Name), condition.Value, given);
}

std::string MakeHints(
  const Described& described, const vtkRelievoParameter& parameter, bool ofArray)
{
  std::ostringstream out;
  out << "        <Hints>\n";
  if (parameter.Usual > 0.0 && !ofArray)
  {
    out << "          <Accepts ";
    if (std::isfinite(parameter.Least) || std::isfinite(parameter.Most))
    {
      out << "min=\"" << std::max(parameter.Least, -1e30) << "\" max=\""
          << std::min(parameter.Most, 1e30) << "\"/>\n";
    }
    else
    {
      out << "finite=\"1\"/>\n";
    }
  }
  if (ofArray)
  {
    out << "          <Array components=\"" << parameter.GetNumberOfComponents() << "\"/>\n";
  }
  // Lamps from data cast shadows even if the shadows of lights are off.
  const bool ofLamps = described.Owner == "shadows:" && parameter.Name == "lamp_map_size";
  out << (ofLamps ? "" : described.Shown);
  for (const vtkRelievoParameter::Condition& condition : parameter.GetConditions())
  {
    out << (ofArray ? "" : DecorateIf(described, condition));
  }
  out << "        </Hints>\n";
  return out.str();
}

// The range of a control. The description may accept a wider one.
std::string MakeDomain(const vtkRelievoParameter& parameter, const Described& described)
{
  using P = vtkRelievoParameter;
  std::ostringstream out;
  out.precision(17);
  if (parameter.Type == P::FLAG)
  {
    out << "        <BooleanDomain name=\"bool\"/>\n";
  }
  else if (parameter.Type == P::CHOICE)
  {
    out << "        <EnumerationDomain name=\"enum\">\n";
    for (std::size_t i = 0; i < parameter.Choices.size(); ++i)
    {
      out << "          <Entry value=\"" << parameter.FirstChoice + static_cast<int>(i)
          << "\" text=\""
          << Escape(described.Verbatim
                 ? parameter.Choices[i]
                 : WriteChoice(parameter.GetChoiceLabel(i), described.Command.empty()))
          << "\"/>\n";
    }
    out << "        </EnumerationDomain>\n";
  }
  else if (parameter.Type == P::COLOR)
  {
    out << "        <DoubleRangeDomain name=\"range\" min=\"0 0 0\" max=\"1 1 1\"/>\n";
  }
  else if (parameter.Type == P::DATE)
  {
    out << "        <IntRangeDomain name=\"range\" min=\"" << parameter.Least << " 1 1\" max=\""
        << parameter.Most << " 12 31\"/>\n";
  }
  else if (parameter.Type == P::WHOLE || parameter.Type == P::NUMBER || parameter.Type == P::SIZE)
  {
    constexpr double above = 1e-3; // stands for an excluded lower bound
    const double least =
      parameter.Usual > 0.0 ? 0.0 : parameter.Least + (parameter.Open ? above : 0.0);
    const double most = parameter.Usual > 0.0 ? parameter.Usual : parameter.Most;
    const auto write = [&](const char* limit, double value) {
      out << " " << limit << "=\"" << value;
      for (int i = 1; i < parameter.GetNumberOfComponents(); ++i)
      {
        out << " " << value;
      }
      out << "\"";
    };
    out << "        <" << (parameter.Type == P::NUMBER ? "Double" : "Int")
        << "RangeDomain name=\"range\"";
    if (least > std::numeric_limits<int>::min())
    {
      write("min", least);
    }
    if (most < std::numeric_limits<int>::max())
    {
      write("max", most);
    }
    out << "/>\n";
  }
  return out.str();
}

// The sentence about the valid values. Properties have a control for each number of a value.
std::string WriteExpected(const vtkRelievoParameter& parameter)
{
  using P = vtkRelievoParameter;
  switch (parameter.Type)
  {
    case P::TEXT:
    case P::SIZE:
    case P::BOX:
      return {};
    case P::DATE:
      return " Takes a year " + parameter.GetBounds() + ", a month and a day.";
    default:
      return " Takes " + parameter.GetExpected() + ".";
  }
}

std::string MakeProperty(const Described& described, const vtkRelievoParameter& parameter)
{
  using P = vtkRelievoParameter;
  const bool text = parameter.Type == P::TEXT;
  const bool whole = parameter.Type == P::FLAG || parameter.Type == P::WHOLE ||
    parameter.Type == P::CHOICE || parameter.Type == P::SIZE || parameter.Type == P::DATE;
  const std::string kind = text ? "String" : whole ? "Int" : "Double";
  const bool own = described.Command.empty();
  const std::string element = (text || own ? "" : "Relievo") + kind + "VectorProperty";
  const std::string name = described.GetName(parameter.Name);
  const std::string words = described.Owner + parameter.Name;
  P ofAll = parameter;
  ofAll.PerPoint = false; // arrays are separate properties
  std::ostringstream out;
  out << "      <" << element << " name=\"" << name << "\" label=\"" << Escape(parameter.GetLabel())
      << "\" command=\""
      << (own ? "Set" + name
              : described.Command + (text ? "Text" : "Value") + "\" initial_string=\"" + words)
      << "\" number_of_elements=\"" << std::max(1, parameter.GetNumberOfComponents())
      << "\" default_values=\"" << FormatDefault(parameter) << "\""
      << (text || own ? "" : " si_class=\"vtkSI" + kind + "VectorProperty\"")
      << (parameter.Type == P::COLOR ? " panel_widget=\"color_selector\"" : "")
      << (parameter.Advanced ? " panel_visibility=\"advanced\"" : "") << ">\n"
      << MakeDomain(parameter, described)
      << Documentation(parameter.Help + WriteExpected(ofAll) +
           (parameter.PerPoint ? " For points without the array." : ""))
      << (own && parameter.OnlyIf.empty() ? "" : MakeHints(described, parameter, false))
      << "      </" << element << ">\n";
  if (parameter.PerPoint)
  {
    out << "      <StringVectorProperty name=\"" << name << "Array\" label=\""
        << Escape(parameter.GetLabel()) << " Array\" command=\"SetArray\" initial_string=\""
        << words << "\" number_of_elements=\"1\" default_values=\"" << parameter.Name
        << "\" animateable=\"0\" panel_visibility=\"advanced\" panel_widget=\"relievo_array\">\n"
        << Documentation(
             "Point array of the " + parameter.Name + " of each; empty takes one for all.")
        << MakeHints(described, parameter, true) << "      </StringVectorProperty>\n";
  }
  return out.str();
}

std::string MakeProperties(const Described& described)
{
  std::string out;
  for (const vtkRelievoParameter& parameter : described.List.Parameters)
  {
    out += MakeProperty(described, parameter);
  }
  return out;
}

std::string Expose(const std::string& property, const std::string& as)
{
  return "            <Property name=\"" + property + "\" exposed_name=\"" + as + "\"/>\n";
}

std::string MakeExposed(const Described& described)
{
  std::string out;
  for (const vtkRelievoParameter& parameter : described.List.Parameters)
  {
    const std::string name = described.GetName(parameter.Name);
    const std::string as = described.GetExposedName(parameter.Name);
    out += Expose(name, as);
    out += parameter.PerPoint ? Expose(name + "Array", as + "Array") : "";
  }
  return out;
}

// `told`: the first argument of the command; empty: none.
std::string MakeSwitch(const std::string& name, const std::string& label,
  const std::string& command, const std::string& told, bool on, const std::string& help)
{
  return "      <RelievoIntVectorProperty name=\"" + name + "\" label=\"" + Escape(label) +
    "\" command=\"" + command + (told.empty() ? "" : "\" initial_string=\"" + told) +
    "\" number_of_elements=\"1\" default_values=\"" + (on ? "1" : "0") +
    "\" si_class=\"vtkSIIntVectorProperty\">\n" + "        <BooleanDomain name=\"bool\"/>\n" +
    Documentation(help) + "      </RelievoIntVectorProperty>\n";
}

// Shows properties while a stage is on, or while one of its layers is the picture.
std::string DecorateInUse(const std::string& on, const std::vector<std::string>& layers)
{
  std::string either = Decorate(on, "1", false);
  for (const std::string& layer : layers)
  {
    either += Decorate("RelievoDisplayLayer", layer, false);
  }
  return layers.empty() ? either
                        : "          <PropertyWidgetDecorator type=\"CompositeDecorator\">\n"
                          "          <Expression type=\"or\">\n" +
      either + "          </Expression>\n          </PropertyWidgetDecorator>\n";
}

// The group of a stage in the view's properties.
void AddStage(vtkRelievoStage* stage, std::map<std::string, std::string>& made)
{
  const vtkRelievoStageDescription& says = stage->GetDescription();
  const std::string name = "Stage" + vtkRelievoCapitalize(says.Name, false);
  // Points have check boxes of their own.
  const std::string label = says.TakesData ? "Draw " + says.Label : says.Label;
  const Described described = { says, "SetStage", says.Name + ":", name, "Relievo",
    DecorateInUse(
      "Relievo" + name, says.ServesWhenOff ? says.Layers : std::vector<std::string>()) };
  made["stages: properties"] +=
    MakeSwitch(name, label, "SetStageOn", says.Name, says.OnByDefault, says.Help) +
    MakeProperties(described);
  made["stages: exposed"] += "          <PropertyGroup label=\"" + Escape(says.Label) +
    " (Relievo)\">\n" + Expose(name, "Relievo" + name) + MakeExposed(described) +
    "          </PropertyGroup>\n";
}

// The proxy of a stage's points, and the XML that adds it to every surface of render views.
std::string MakePoints(vtkRelievoPointStage* stage)
{
  const auto points = vtkSmartPointer<vtkRelievoPointValues>::Take(stage->NewPoints());
  if (points->GetDescription().Find("up"))
  {
    points->SetParameter("up", "0,0,1"); // up axis of ParaView's scenes
  }
  const std::string name = vtkRelievoCapitalize(stage->GetStageName(), false);
  const std::string things = points->GetThings();
  const Described described = { points->GetDescription(), "Set", stage->GetStageName() + ":", "",
    "Relievo" + name, Decorate("Relievo" + name, "1", false) };
  std::ostringstream out;
  out << "  <ProxyGroup name=\"relievo\">\n    <RelievoSurfaceProxy name=\"" << name
      << "\" class=\"vtkPVRelievoPoints\" processes=\"client|renderserver\">\n"
      << "      <Documentation short_help=\"Points as " << things << "\">Each point of a surface "
      << "representation, as " << things << " in the view.</Documentation>\n"
      << MakeSwitch("Enabled", "Points Are " + vtkRelievoCapitalize(things, true), "SetEnabled", "",
           false,
           "Whether the points are " + things +
             " in the view. For the representations Surface, Points, Wireframe and the "
             "like.")
      << MakeProperties(described) << "    </RelievoSurfaceProxy>\n  </ProxyGroup>\n"
      << "  <ProxyGroup name=\"internal_representations\">\n"
      << "    <Extension name=\"PVRepresentationBase\">\n      <SubProxy>\n"
      << "        <Proxy name=\"Relievo" << name << "\" proxygroup=\"relievo\" proxyname=\"" << name
      << "\"/>\n        <ExposedProperties>\n          <PropertyGroup label=\"" << name
      << " (Relievo)\">\n"
      << Expose("Enabled", "Relievo" + name) << MakeExposed(described)
      << "          </PropertyGroup>\n        </ExposedProperties>\n"
      << "      </SubProxy>\n    </Extension>\n  </ProxyGroup>\n";
  return out.str();
}

// Layers with a name of their own, so without those of lights.
std::vector<vtkRelievoLayer> GetNamedLayers()
{
  std::vector<vtkRelievoLayer> layers = vtkRelievoLayerCatalogue::GetAll();
  layers.erase(std::remove_if(layers.begin(), layers.end(),
                 [](const vtkRelievoLayer& layer) { return layer.OfLight; }),
    layers.end());
  return layers;
}

std::string MakeLayers(bool withPicture)
{
  std::string out;
  for (const vtkRelievoLayer& layer : GetNamedLayers())
  {
    const bool listed = withPicture || layer.Source != vtkRelievoLayer::FROM_PICTURE;
    out += listed ? "          <String value=\"" + layer.Name + "\"/>\n" : "";
  }
  return out;
}

std::string MakeLayersHelp()
{
  std::string out;
  for (const vtkRelievoLayer& layer : GetNamedLayers())
  {
    const bool told = layer.Source != vtkRelievoLayer::FROM_PICTURE;
    out += told ? (out.empty() ? "" : "; ") + layer.Name + ": " + Escape(layer.Help) : "";
  }
  return out;
}

std::string MakeSelection(const std::string& words)
{
  std::istringstream in(words);
  std::vector<std::string> chosen;
  for (std::string word; in >> word;)
  {
    chosen.push_back(word);
  }
  std::vector<vtkRelievoLayer> layers = GetNamedLayers();
  std::stable_partition(layers.begin(), layers.end(), [&chosen](const vtkRelievoLayer& layer) {
    return !chosen.empty() && layer.Name == chosen.front();
  });
  std::string out;
  for (const vtkRelievoLayer& layer : layers)
  {
    const bool on = std::find(chosen.begin(), chosen.end(), layer.Name) != chosen.end();
    out += (out.empty() ? "" : " ") + layer.Name + (on ? " 1" : " 0");
  }
  return out;
}

// The line with @images@, @models@ and @layers: ...@ replaced.
std::string FillIn(const std::string& line)
{
  for (const auto& [mark, extensions] :
    { std::pair{ "@images@", vtkRelievoImageFile::ListExtensions() },
      std::pair{ "@models@", vtkRelievoModelReader::GetExtensions() } })
  {
    const std::size_t at = line.find(mark);
    if (at != std::string::npos)
    {
      return line.substr(0, at) + extensions + line.substr(at + std::strlen(mark));
    }
  }
  const std::string mark = "@layers: ";
  const std::size_t from = line.find(mark);
  const std::size_t to = from == std::string::npos ? from : line.find('@', from + 1);
  if (to == std::string::npos)
  {
    return line;
  }
  const std::string what = line.substr(from + mark.size(), to - from - mark.size());
  const std::string filled = what == "help" ? MakeLayersHelp()
    : what == "count"                       ? std::to_string(2 * GetNamedLayers().size())
                                            : MakeSelection(what);
  return line.substr(0, from) + filled + FillIn(line.substr(to + 1));
}

// The text that replaces a comment of the template.
std::map<std::string, std::string> MakeAll()
{
  std::map<std::string, std::string> made = { { "layers", MakeLayers(true) },
    { "layers: shown", MakeLayers(false) } };
  vtkNew<vtkRelievoPass> frame;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    const vtkRelievoStageDescription& stage = frame->GetStage(i)->GetDescription();
    // Stages that are always on have a group only for data, or for the rule of volumes.
    const bool isSwitched = !stage.OnByDefault || stage.TakesData || stage.Name == "volumes";
    if (isSwitched && frame->GetStage(i) != frame->GetShadowStage())
    {
      AddStage(frame->GetStage(i), made);
    }
    if (auto* drawsPoints = vtkRelievoPointStage::SafeDownCast(frame->GetStage(i)))
    {
      made["points"] += MakePoints(drawsPoints);
    }
  }
  const auto add = [&made](const std::string& name, const Described& described) {
    made[name + ": properties"] = MakeProperties(described);
    made[name + ": exposed"] = MakeExposed(described);
  };
  vtkPVRelievoSun sun;
  add("sun",
    { sun.GetDescription(), "SetSun", "", "Sun", "Relievo", Decorate("RelievoSun", "1", false) });
  // A single value applies to all points of the selection.
  vtkNew<vtkRelievoMarkers> markers;
  vtkRelievoParameterList ofSelection = markers->GetDescription();
  for (vtkRelievoParameter& parameter : ofSelection.Parameters)
  {
    parameter.PerPoint = false;
  }
  ofSelection.TrySet("shape", "glow");
  ofSelection.TrySet("up", "0,0,1");
  add("selection",
    { ofSelection, "SetMarkSelection", "", "MarkSelection", "Relievo",
      Decorate("RelievoMarkSelection", "1", false) });
  add("shadows",
    { frame->GetShadowStage()->GetDescription(), "SetStage", "shadows:", "Shadow", "Relievo",
      Decorate("RelievoShadows", "1", false) });
  vtkRelievoParameterList ofLayer = frame->GetStage("display")->GetDescription();
  ofLayer.Parameters.erase(ofLayer.Parameters.begin()); // the layer, a list
  for (vtkRelievoParameter& parameter : ofLayer.Parameters)
  {
    parameter.Advanced = true;
  }
  add("display",
    { ofLayer, "SetStage", "display:", "Display", "Relievo",
      Decorate("RelievoDisplayLayer", "None", true), true });
  vtkNew<vtkRelievoEnvironment> environment;
  environment->SetUpAxis(2); // as in vtkPVRelievoView
  environment->GammaCorrectOn();
  add("environment",
    { environment->GetDescription(), "SetEnvironment", "", "Environment", "Relievo",
      Decorate("RelievoEnvironment", "", true) });
  vtkNew<vtkRelievoMaterial> material;
  add("material",
    { material->GetDescription(), "Set", "", "", "Relievo",
      Decorate("RelievoMaterial", "1", false) });
  const auto addFilter = [&add](const std::string& name, const auto& filter) {
    add(name, { filter->GetParameters(), "", "", "", "", "" });
  };
  addFilter("bone weights", vtkNew<vtkRelievoBoneWeights>());
  addFilter("caves", vtkNew<vtkRelievoCaves>());
  addFilter("depth to points", vtkNew<vtkRelievoDepthToPoints>());
  addFilter("exr reader", vtkNew<vtkRelievoEXRReader>());
  addFilter("exr writer", vtkNew<vtkRelievoEXRWriter>());
  addFilter("environment convert", vtkNew<vtkRelievoEnvironmentConvert>());
  addFilter("environment irradiance", vtkNew<vtkRelievoEnvironmentIrradiance>());
  addFilter("environment prefilter", vtkNew<vtkRelievoEnvironmentPrefilter>());
  addFilter("heights to normals", vtkNew<vtkRelievoHeightsToNormals>());
  addFilter("model reader", vtkNew<vtkRelievoModelReader>());
  addFilter("skin", vtkNew<vtkRelievoSkin>());
  addFilter("smooth blocks", vtkNew<vtkRelievoSmoothBlocks>());
  addFilter("tangents", vtkNew<vtkRelievoTangents>());
  addFilter("texture coordinates", vtkNew<vtkRelievoTextureCoordinates>());
  addFilter("visibility", vtkNew<vtkPVRelievoVisibility>());
  addFilter("voxel cubes", vtkNew<vtkRelievoVoxelCubes>());
  addFilter("voxel shell", vtkNew<vtkRelievoVoxelShell>());
  vtkNew<vtkRelievoSurfaceParticles> particles;
  particles->SetNoiseSpeed(-1.0); // a default with visible motion
  addFilter("surface particles", particles);
  vtkNew<vtkRelievoSunExposure> exposure;
  exposure->SetUpAxis(2);
  addFilter("sun exposure", exposure);
  addFilter("cover", vtkNew<vtkRelievoCover>());
  addFilter("view factors", vtkNew<vtkRelievoViewFactors>());
  addFilter("viewshed", vtkNew<vtkRelievoViewshed>());
  return made;
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "describeProperties: expected TEMPLATE OUTPUT\n";
    return 2;
  }
  const std::map<std::string, std::string> made = MakeAll();
  std::ifstream in(argv[1]);
  std::ostringstream out;
  for (std::string line; std::getline(in, line);)
  {
    const std::size_t begin = line.find("<!-- "), end = line.rfind(" -->");
    const bool comment = begin != std::string::npos && end != std::string::npos && end > begin + 4;
    const auto found = made.find(comment ? line.substr(begin + 5, end - begin - 5) : "");
    out << (found == made.end() ? FillIn(line) + "\n" : found->second);
  }
  std::ofstream file(argv[2]);
  file << out.str();
  file.close();
  if (in.bad() || out.str().empty() || !file)
  {
    std::cerr << "describeProperties: " << argv[1] << " cannot be read, or " << argv[2]
              << " cannot be written\n";
    return 1;
  }
  return 0;
}
