// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// describeStages TEMPLATE OUTPUT: writes the XML of the view's properties, in which the stages' own
// are made from the stages' descriptions, and lists of layers from the catalogue. Run by the build.
//
// A comment `points` in the template becomes the proxies of points of surfaces, for every stage
// that draws such; `stages: properties` becomes the properties of every stage that is not always
// there, `stages: exposed` their groups in the render view, `layers` the names of layers,
// `layers: shown` those that can be shown as the picture. In other lines @layers: help@ is what
// they are, @layers: count@ how many values a selection of layers has, and @layers: A B@ the
// values of one in which A and B are chosen, A first.
#include "vtkNew.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"
#include "vtkRelievoStage.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
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

std::string Numbers(const std::vector<double>& values)
{
  std::ostringstream out;
  out.precision(17);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    out << (i ? " " : "") << values[i];
  }
  return out.str();
}

// Every name is a file format: state files and scripts hold it.
std::string GetPropertyName(const vtkRelievoStageDescription& stage, const std::string& parameter)
{
  return "Stage" + vtkRelievoCapitalize(stage.Name, false) + vtkRelievoCapitalize(parameter, false);
}

std::string Documentation(const std::string& help)
{
  return "        <Documentation>" + Escape(help) + "</Documentation>\n";
}

std::string Range(const vtkRelievoParameter& parameter, const char* domain)
{
  std::ostringstream out;
  out.precision(17);
  out << "        <" << domain << " name=\"range\"";
  const auto count = static_cast<std::size_t>(parameter.GetNumberOfComponents());
  if (std::isfinite(parameter.Least))
  {
    out << " min=\"" << Numbers(std::vector<double>(count, parameter.Least)) << "\"";
  }
  if (std::isfinite(parameter.Most))
  {
    out << " max=\"" << Numbers(std::vector<double>(count, parameter.Most)) << "\"";
  }
  out << "/>\n";
  return out.str();
}

std::string MakeProperty(
  const vtkRelievoStageDescription& stage, const vtkRelievoParameter& parameter)
{
  using P = vtkRelievoParameter;
  const bool text = parameter.Type == P::TEXT;
  const bool whole =
    parameter.Type == P::FLAG || parameter.Type == P::WHOLE || parameter.Type == P::CHOICE;
  const std::string kind = text ? "String" : whole ? "Int" : "Double";
  const std::string name = GetPropertyName(stage, parameter.Name);
  std::ostringstream out;
  const std::string element = (text ? "" : "Relievo") + kind + "VectorProperty";
  out << "      <" << element << " name=\"" << name << "\" label=\"" << Escape(parameter.GetLabel())
      << "\" command=\"SetStage" << (text ? "Text" : "Value") << "\" initial_string=\""
      << stage.Name << ":" << parameter.Name << "\" number_of_elements=\""
      << std::max(1, parameter.GetNumberOfComponents()) << "\" default_values=\""
      << (text ? Escape(parameter.Format()) : Numbers(parameter.GetValues())) << "\""
      << (text ? "" : " si_class=\"vtkSI" + kind + "VectorProperty\"")
      << (parameter.Type == P::COLOR ? " panel_widget=\"color_selector\"" : "") << ">\n";
  if (parameter.Type == P::FLAG)
  {
    out << "        <BooleanDomain name=\"bool\"/>\n";
  }
  else if (parameter.Type == P::CHOICE)
  {
    out << "        <EnumerationDomain name=\"enum\">\n";
    for (std::size_t i = 0; i < parameter.Choices.size(); ++i)
    {
      out << "          <Entry value=\"" << i << "\" text=\""
          << Escape(vtkRelievoCapitalize(parameter.Choices[i], true)) << "\"/>\n";
    }
    out << "        </EnumerationDomain>\n";
  }
  else if (!text)
  {
    out << Range(parameter, whole ? "IntRangeDomain" : "DoubleRangeDomain");
  }
  out << Documentation(parameter.Help + (text ? "" : " Takes " + parameter.GetExpected() + "."))
      << "        <Hints>\n"
      << "          <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\" "
      << "property=\"Relievo" << GetPropertyName(stage, "") << "\" value=\"1\"/>\n"
      << "        </Hints>\n      </" << element << ">\n";
  return out.str();
}

std::string MakeProperties(const vtkRelievoStageDescription& stage)
{
  std::ostringstream out;
  out << "      <RelievoIntVectorProperty name=\"" << GetPropertyName(stage, "") << "\" label=\""
      << Escape(stage.Label) << "\" command=\"SetStageOn\" initial_string=\"" << stage.Name
      << "\" number_of_elements=\"1\" default_values=\"" << (stage.OnByDefault ? 1 : 0) << "\" "
      << "si_class=\"vtkSIIntVectorProperty\">\n"
      << "        <BooleanDomain name=\"bool\"/>\n"
      << Documentation(stage.Help) << "      </RelievoIntVectorProperty>\n";
  for (const vtkRelievoParameter& parameter : stage.Parameters)
  {
    out << MakeProperty(stage, parameter);
  }
  return out.str();
}

std::string MakeExposed(const vtkRelievoStageDescription& stage)
{
  std::ostringstream out;
  auto expose = [&out, &stage](const std::string& parameter) {
    const std::string name = GetPropertyName(stage, parameter);
    out << "            <Property name=\"" << name << "\" exposed_name=\"Relievo" << name
        << "\"/>\n";
  };
  out << "          <PropertyGroup label=\"" << Escape(stage.Label) << " (Relievo)\">\n";
  expose("");
  for (const vtkRelievoParameter& parameter : stage.Parameters)
  {
    expose(parameter.Name);
  }
  out << "          </PropertyGroup>\n";
  return out.str();
}

// Of points of surfaces. What a control shows beyond is taken from scripts as well.
std::string MakeRange(const vtkRelievoParameter& parameter)
{
  std::ostringstream out;
  out.precision(17);
  const bool colored = parameter.Type == vtkRelievoParameter::COLOR;
  const bool slides = parameter.Usual > 0.0;
  if (colored)
  {
    out << "        <DoubleRangeDomain name=\"range\" min=\"0 0 0\" max=\"1 1 1\"/>\n";
  }
  else if (slides)
  {
    out << "        <DoubleRangeDomain name=\"range\" min=\"0\" max=\"" << parameter.Usual
        << "\"/>\n";
  }
  else
  {
    out << Range(parameter, "DoubleRangeDomain");
  }
  return out.str();
}

std::string MakeHints(const std::string& stage, const vtkRelievoParameterList& points,
  const vtkRelievoParameter& parameter, bool ofArray)
{
  std::ostringstream out;
  out << "        <Hints>\n";
  if (parameter.Usual > 0.0 && !ofArray)
  {
    out << "          <Accepts min=\"" << std::max(parameter.Least, -1e30) << "\" max=\""
        << std::min(parameter.Most, 1e30) << "\"/>\n";
  }
  const auto decorate = [&out](const std::string& property, int value) {
    out << "          <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\" "
        << "property=\"Relievo" << property << "\" value=\"" << value << "\"/>\n";
  };
  decorate(vtkRelievoCapitalize(stage, false), 1);
  const std::size_t equals = parameter.OnlyIf.find('=');
  if (equals != std::string::npos && !ofArray)
  {
    const std::string other = parameter.OnlyIf.substr(0, equals);
    const std::vector<std::string>& choices = points.Find(other)->Choices;
    decorate(vtkRelievoCapitalize(stage, false) + vtkRelievoCapitalize(other, false),
      static_cast<int>(
        std::find(choices.begin(), choices.end(), parameter.OnlyIf.substr(equals + 1)) -
        choices.begin()));
  }
  out << "        </Hints>\n";
  return out.str();
}

std::string MakeEntry(std::size_t value, const std::string& choice)
{
  const std::string text = choice == "vtk" ? "VTK" : vtkRelievoCapitalize(choice, true);
  return "          <Entry value=\"" + std::to_string(value) + "\" text=\"" + Escape(text) +
    "\"/>\n";
}

std::string MakePointProperty(const std::string& stage, const vtkRelievoParameterList& points,
  const vtkRelievoParameter& parameter)
{
  using P = vtkRelievoParameter;
  const bool choice = parameter.Type == P::CHOICE;
  const std::string name = vtkRelievoCapitalize(parameter.Name, false);
  const std::string kind = choice ? "Int" : "Double";
  const std::string element =
    (parameter.Type == P::VECTOR ? "" : "Relievo") + kind + "VectorProperty";
  // ParaView's worlds have z up.
  const std::string standard = parameter.Name == "up" ? "0 0 1" : Numbers(parameter.GetValues());
  std::ostringstream out;
  out << "      <" << element << " name=\"" << name << "\" label=\"" << Escape(parameter.GetLabel())
      << "\" command=\"SetValue\" initial_string=\"" << stage << ":" << parameter.Name
      << "\" number_of_elements=\"" << parameter.GetNumberOfComponents() << "\" default_values=\""
      << standard << "\" si_class=\"vtkSI" << kind << "VectorProperty\""
      << (parameter.Type == P::COLOR ? " panel_widget=\"color_selector\"" : "") << ">\n";
  if (choice)
  {
    out << "        <EnumerationDomain name=\"enum\">\n";
    for (std::size_t i = 0; i < parameter.Choices.size(); ++i)
    {
      out << MakeEntry(i, parameter.Choices[i]);
    }
    out << "        </EnumerationDomain>\n";
  }
  else if (parameter.Type != P::VECTOR)
  {
    out << MakeRange(parameter);
  }
  const std::string unit = parameter.Unit.empty() ? "" : " (" + parameter.Unit + ")";
  out << Documentation(
           parameter.Help + unit + (parameter.PerPoint ? " For points without the array." : ""))
      << MakeHints(stage, points, parameter, false) << "      </" << element << ">\n";
  if (parameter.PerPoint)
  {
    out << "      <StringVectorProperty name=\"" << name << "Array\" label=\""
        << Escape(parameter.GetLabel()) << " Array\" command=\"SetArray\" initial_string=\""
        << stage << ":" << parameter.Name << "\" number_of_elements=\"1\" default_values=\""
        << parameter.Name << "\" animateable=\"0\" panel_visibility=\"advanced\">\n"
        << Documentation(
             "Point array of the " + parameter.Name + " of each; empty takes one for all.")
        << MakeHints(stage, points, parameter, true) << "      </StringVectorProperty>\n";
  }
  return out.str();
}

// The proxy of a stage's points, and how every surface of render views begins with it.
std::string MakePoints(vtkRelievoPointStage* stage)
{
  const auto points = vtkSmartPointer<vtkRelievoPointValues>::Take(stage->NewPoints());
  const std::string name = vtkRelievoCapitalize(stage->GetStageName(), false);
  const std::string things = points->GetThings();
  std::ostringstream out;
  std::ostringstream exposed;
  const auto expose = [&](const std::string& property, const std::string& as) {
    exposed << "            <Property name=\"" << property << "\" exposed_name=\"Relievo" << name
            << as << "\"/>\n";
  };
  out << "  <ProxyGroup name=\"relievo\">\n    <RelievoSurfaceProxy name=\"" << name
      << "\" class=\"vtkPVRelievoPoints\" processes=\"client|renderserver\">\n"
      << "      <Documentation short_help=\"Points as " << things << "\">Each point of a surface "
      << "representation, as " << things << " in what the view shows.</Documentation>\n"
      << "      <RelievoIntVectorProperty name=\"Enabled\" label=\"" << name
      << "\" command=\"SetEnabled\" number_of_elements=\"1\" default_values=\"0\" "
      << "si_class=\"vtkSIIntVectorProperty\">\n        <BooleanDomain name=\"bool\"/>\n"
      << Documentation("Whether the points are " + things +
           " in what the view shows. For the representations Surface, Points, Wireframe and the "
           "like.")
      << "      </RelievoIntVectorProperty>\n";
  expose("Enabled", "");
  const vtkRelievoParameterList& description = points->GetDescription();
  for (const vtkRelievoParameter& parameter : description.Parameters)
  {
    out << MakePointProperty(stage->GetStageName(), description, parameter);
    const std::string property = vtkRelievoCapitalize(parameter.Name, false);
    expose(property, property);
    if (parameter.PerPoint)
    {
      expose(property + "Array", property + "Array");
    }
  }
  out << "    </RelievoSurfaceProxy>\n  </ProxyGroup>\n"
      << "  <ProxyGroup name=\"internal_representations\">\n"
      << "    <Extension name=\"PVRepresentationBase\">\n      <SubProxy>\n"
      << "        <Proxy name=\"Relievo" << name << "\" proxygroup=\"relievo\" proxyname=\"" << name
      << "\"/>\n        <ExposedProperties>\n          <PropertyGroup label=\"" << name
      << " (Relievo)\">\n"
      << exposed.str() << "          </PropertyGroup>\n        </ExposedProperties>\n"
      << "      </SubProxy>\n    </Extension>\n  </ProxyGroup>\n";
  return out.str();
}

// Those that have a name of their own: not those of lights.
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

// The line with what stands for its @layers: ...@.
std::string FillIn(const std::string& line)
{
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
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "describeStages: expected TEMPLATE OUTPUT\n";
    return 2;
  }
  std::string properties;
  std::string exposed;
  std::string points;
  vtkNew<vtkRelievoPass> frame;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    const vtkRelievoStageDescription& stage = frame->GetStage(i)->GetDescription();
    if (!stage.OnByDefault || stage.TakesData)
    {
      properties += MakeProperties(stage);
      exposed += MakeExposed(stage);
    }
    if (auto* drawsPoints = vtkRelievoPointStage::SafeDownCast(frame->GetStage(i)))
    {
      points += MakePoints(drawsPoints);
    }
  }
  std::ifstream in(argv[1]);
  std::ostringstream out;
  for (std::string line; std::getline(in, line);)
  {
    out << (line.find("<!-- stages: properties -->") != std::string::npos ? properties
        : line.find("<!-- points -->") != std::string::npos               ? points
        : line.find("<!-- stages: exposed -->") != std::string::npos      ? exposed
        : line.find("<!-- layers -->") != std::string::npos               ? MakeLayers(true)
        : line.find("<!-- layers: shown -->") != std::string::npos        ? MakeLayers(false)
                                                                          : FillIn(line) + "\n");
  }
  std::ofstream file(argv[2]);
  file << out.str();
  file.close();
  if (in.bad() || out.str().empty() || !file)
  {
    std::cerr << "describeStages: " << argv[1] << " cannot be read, or " << argv[2]
              << " cannot be written\n";
    return 1;
  }
  return 0;
}
