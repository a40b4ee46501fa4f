// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowInternals.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <sstream>

vtkStandardNewMacro(vtkRelievoShadowPass);

//------------------------------------------------------------------------------
vtkRelievoShadowPass::vtkRelievoShadowPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoShadowPass::~vtkRelievoShadowPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetLightCasts(vtkLight* light, bool casts)
{
  auto& list = this->Internal->NotCasting;
  list.erase(std::remove_if(list.begin(), list.end(),
               [light](const vtkWeakPointer<vtkLight>& known) {
                 return !known || known.GetPointer() == light;
               }),
    list.end());
  if (!casts && light)
  {
    list.emplace_back(light);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::GetLightCasts(vtkLight* light)
{
  return this->Internal->IsChosen(light);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetPropCasts(vtkProp* prop, int casts)
{
  if (!prop || casts < CASTS_IF_OPAQUE || casts > CASTS_ALWAYS)
  {
    vtkErrorMacro("SetPropCasts was given " << (prop ? "casting " : "no prop and casting ") << casts
                                            << "; give it a vtkProp of the renderer, and "
                                            << "-1 (if opaque), 0 (never) or 1 (always).");
    return;
  }
  this->Internal->Props.GetChoice(prop).Casts = casts;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetPropCasts(vtkProp* prop)
{
  return this->Internal->Props.GetChoice(prop).Casts;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::AddPlainActorClass(const std::string& name)
{
  vtkRelievoCasterDraw::AddActorClass(name);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetPropReceives(vtkProp* prop, bool receives)
{
  if (!prop)
  {
    vtkErrorMacro("SetPropReceives was given no prop; give it a vtkProp of the renderer.");
    return;
  }
  this->Internal->Props.GetChoice(prop).Receives = receives;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::GetPropReceives(vtkProp* prop)
{
  return this->Internal->Props.GetChoice(prop).Receives;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetController(vtkMultiProcessController* controller)
{
  if (this->GetController() != controller)
  {
    this->Internal->Exchange.SetController(controller);
    this->Internal->Cache.Clear(); // maps of this process alone, or of others that are gone
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoShadowPass::GetController()
{
  return this->Internal->Exchange.GetController();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::GetMergeSeconds()
{
  return this->Internal->Exchange.GetSeconds();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetNumberOfCastingLights()
{
  return static_cast<int>(this->Internal->Casting.size());
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetNumberOfMaps()
{
  return this->Internal->Cache.GetNumberOfMaps();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "shadows";
  description.Help = "Makes blocked lights leave shadows.";
  description.Slot = vtkRelievoStageDescription::LIGHT_MAPS;
  description.Writes = { "shadow maps" };
  description.OnByDefault = true;
  description.AddFlag(
    "visible", this->Visible, [this](bool on) { this->SetVisible(on); },
    "Whether shadows are seen in the picture.");
  description.AddChoice(
    "method", this->Method, [this](int method) { this->SetMethod(method); },
    { "map", "forward", "warped" }, "How it is found out whether a light is blocked.");
  description.AddWhole(
    "map_size", this->MapSize, [this](int size) { this->SetMapSize(size); }, 16, 16384, "texels",
    "Width and height of each light's map.");
  description.AddWhole(
    "filter_radius", this->FilterRadius, [this](int radius) { this->SetFilterRadius(radius); }, 0,
    16, "texels", "How soft the edges of shadows are.");
  description.AddNumber(
    "bias", this->Bias, [this](double bias) { this->SetBias(bias); }, 0.0, 100.0, "texels",
    "How far behind what the light sees a surface may lie and still be lit.");
  description.AddNumber(
    "strength", this->Strength, [this](double strength) { this->SetStrength(strength); }, 0.0, 1.0,
    "", "Part of a blocked light that is taken away.");
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  // For layers, whether shadows are seen or not.
  declaration.Writes.emplace_back("visibility");
  declaration.Offers = this->Visible;
  declaration.Words = this->Visible ? "" : "shadows are off";
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoAccess::Renderer::FollowCamera(context.Renderer);
  // The shaders that draw the maps are built for the lights that VTK counts here.
  static_cast<vtkOpenGLRenderer*>(context.Renderer)->UpdateLights();
  in.Lights = vtkRelievoShadowLight::Collect(context.Renderer);
  in.Casting.clear();
  in.WithoutShadow.clear();
  int faces = 0;
  const int mostFaces = vtkRelievoShadowMaps::GetMostFaces();
  for (vtkRelievoShadowLight& light : in.Lights)
  {
    if (light.NoShadow.empty() && !in.IsChosen(light.Light))
    {
      light.NoShadow = "it is chosen so";
    }
    if (light.NoShadow.empty() && faces + (light.Positional ? 6 : 1) > mostFaces)
    {
      light.NoShadow = "the lights before it take all maps that a shader has room for";
      light.Broken = true;
    }
    if (light.NoShadow.empty())
    {
      faces += light.Positional ? 6 : 1;
      in.Casting.push_back(light);
      continue;
    }
    in.WithoutShadow += "; " + in.GetName(light) + " casts none: " + light.NoShadow;
    if (light.Broken && in.Said.insert(std::to_string(light.Number) + light.NoShadow).second)
    {
      vtkWarningMacro(<< in.GetName(light) << " casts no shadow: " << light.NoShadow << ".");
    }
  }
  if (in.Casting.empty())
  {
    this->Explain("no_lights", "no light casts" + in.WithoutShadow);
    return false;
  }
  this->DrawCalls = 0;
  this->NumberOfMapsDrawn = 0;
  in.LayersAsked = context.IsAsked(this, "visibility");
  in.View = context.View;
  in.Props.Collect(context.State);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::ExplainMaps()
{
  Internals& in = *this->Internal;
  std::ostringstream out;
  out << in.Casting.size() << (in.Casting.size() == 1 ? " light casts" : " lights cast");
  for (const vtkRelievoShadowLight& light : in.Casting)
  {
    out << (&light == in.Casting.data() ? " (" : ", ") << in.GetName(light);
  }
  out << "), " << in.Cache.GetNumberOfMaps()
      << (in.Cache.GetNumberOfMaps() == 1 ? " map of " : " maps of ") << in.Maps.GetSize() << " x "
      << in.Maps.GetSize() << " texels, " << this->NumberOfMapsDrawn << " drawn anew"
      << in.Exchange.GetReport() << in.WithoutShadow;
  this->Explain("ran", out.str());
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.View.Viewport[2] <= 0 || in.View.Viewport[3] <= 0)
  {
    return;
  }
  const vtkRenderState* s = context.State;
  in.Window = context.Window;
  in.PlainDraw.SetWindow(in.Window);
  this->FitMaps(s);
  if (!in.Maps.Bind(false))
  {
    this->Explain("failed", "all texture units of this OpenGL are taken");
    if (in.Said.insert("unit").second)
    {
      vtkErrorMacro("No shadows: all texture units of this OpenGL are taken. Use fewer textures.");
    }
    return;
  }
  in.Spliced = true;
  in.Props.AddPass(this);
  this->DrawMaps(s);
  in.Maps.Bind(true);
  if (this->Method == METHOD_FORWARD)
  {
    in.Told.clear();
    this->DrawMasks(s);
  }
  else
  {
    in.Masks.Release(context.Window);
  }
  in.Told.clear();
  this->ExplainMaps();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Finish(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Spliced)
  {
    in.Props.RemovePass(this);
    in.Maps.Unbind();
    in.Masks.Unbind();
    in.Spliced = false;
    if (in.Props.ChangesByDrawing())
    {
      // Some mappers count themselves as modified when they draw.
      in.Props.Collect(context.State);
      in.Cache.SetCasters(in.Props);
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowPass::GetBytesHeld()
{
  return this->Internal->Maps.GetBytes() + this->Internal->Masks.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Maps.Release(window);
  this->Internal->Masks.Release(window);
  this->Internal->PlainDraw.Release(window);
  this->Internal->Cache.Clear();
  this->Internal->Casting.clear();
  this->NumberOfMapsDrawn = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Visible: " << this->Visible << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "FilterRadius: " << this->FilterRadius << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Casting lights: " << this->GetNumberOfCastingLights() << "\n";
  os << indent << "Maps: " << this->GetNumberOfMaps() << "\n";
}
