// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFillStage.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoDeclaration.h"
#include "vtkRelievoFillLight.h"
#include "vtkRelievoFillSplice.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoOpaqueMeshes.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoShadowCatcher.h"
#include "vtkRelievoSkyGrid.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>

vtkStandardNewMacro(vtkRelievoFillStage);

namespace
{
const vtkRelievoResourceName Resource = vtkRelievoResourceName::Of("fill light");

// The fill lights that are on.
std::vector<vtkRelievoFrameLight> FindFillLights(vtkRenderer* renderer)
{
  std::vector<vtkRelievoFrameLight> found;
  for (const vtkRelievoFrameLight& light : vtkRelievoFrameScene::FindLights(renderer))
  {
    if (light.ShaderIndex >= 0 && vtkRelievoFillLight::Is(light.Light))
    {
      found.push_back(light);
    }
  }
  return found;
}

// The ground is a flat shadow catcher, inside the view or not, that the eye is not below.
vtkRelievoSkyGrid::Ground FindGround(vtkRenderer* renderer)
{
  vtkRelievoSkyGrid::Ground ground;
  double around[6];
  renderer->ComputeVisiblePropBounds(around);
  for (const vtkRelievoFrameProp& prop : vtkRelievoFrameScene::FindVisible(renderer))
  {
    const double* bounds =
      vtkRelievoShadowCatcher::Is(prop.Prop) ? prop.Prop->GetBounds() : nullptr;
    for (int axis = 0; bounds && axis < 3; ++axis)
    {
      if (bounds[2 * axis] == bounds[2 * axis + 1])
      {
        const double height = bounds[2 * axis];
        const bool above = around[2 * axis + 1] - height >= height - around[2 * axis];
        const double eye = renderer->GetActiveCamera()->GetPosition()[axis];
        ground =
          above == (eye > height) ? vtkRelievoSkyGrid::Ground{ axis, above, height } : ground;
      }
    }
  }
  return ground;
}
}

class vtkRelievoFillStage::Internals
{
public:
  vtkNew<vtkRelievoFillSplice> Splice;
  vtkRelievoOpaqueMeshes Meshes;
  vtkRelievoSkyGrid Grid;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the texture
  std::array<glm::vec3, 9> Coefficients{};      // in eye space

  // Makes the grid's texture; false if there is none.
  bool Load(vtkOpenGLRenderWindow* window, bool isNew);

  void Tell(
    vtkShaderProgram* program, const vtkRelievoFrameCamera& view, bool sky, double strength);
};

//------------------------------------------------------------------------------
bool vtkRelievoFillStage::Internals::Load(vtkOpenGLRenderWindow* window, bool isNew)
{
  const bool there =
    this->Texture && this->Window == window && this->Texture->GetHandle() != 0 && !isNew;
  if (there || this->Grid.IsEmpty())
  {
    return there && !this->Grid.IsEmpty();
  }
  this->Window = window;
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  const glm::ivec3& size = this->Grid.GetSize();
  std::vector<std::uint8_t> texels = this->Grid.GetTexels(); // which VTK takes as not constant
  return this->Texture->Create3DFromRaw(static_cast<unsigned int>(size.x),
    static_cast<unsigned int>(size.y), static_cast<unsigned int>(size.z), 4, VTK_UNSIGNED_CHAR,
    texels.data());
}

//------------------------------------------------------------------------------
void vtkRelievoFillStage::Internals::Tell(
  vtkShaderProgram* program, const vtkRelievoFrameCamera& view, bool sky, double strength)
{
  program->SetUniform3fv(
    "relievoFillLight", 9, reinterpret_cast<const float(*)[3]>(this->Coefficients.data()));
  if (!sky)
  {
    return;
  }
  const glm::dmat4 toWorld = glm::inverse(view.WorldToView);
  const glm::mat4 toTexture(this->Grid.GetWorldToTexture() * toWorld);
  const glm::mat3 directions(toWorld);
  program->SetUniformi("relievoFillSky", this->Texture->GetTextureUnit());
  program->SetUniformMatrix4x4("relievoFillToSky", const_cast<float*>(&toTexture[0][0]));
  program->SetUniformMatrix3x3("relievoFillToWorld", const_cast<float*>(&directions[0][0]));
  program->SetUniformf("relievoFillAway", static_cast<float>(this->Grid.GetAway()));
  program->SetUniformi("relievoFillParallel", view.Parallel ? 1 : 0);
  program->SetUniformf("relievoFillStrength", static_cast<float>(strength));
}

//------------------------------------------------------------------------------
vtkRelievoFillStage::vtkRelievoFillStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoFillStage::~vtkRelievoFillStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoFillStage::SetLightFills(vtkLight* light, bool fills)
{
  if (!light || (fills && light->GetPositional()))
  {
    vtkErrorMacro("SetLightFills was given " << (light ? "a positional light" : "no light")
                                             << "; give it a distant light (PositionalOff).");
    return;
  }
  fills ? vtkRelievoFillLight::Make(light) : vtkRelievoFillLight::Clear(light);
}

//------------------------------------------------------------------------------
bool vtkRelievoFillStage::GetLightFills(vtkLight* light)
{
  return light && vtkRelievoFillLight::Is(light);
}

//------------------------------------------------------------------------------
void vtkRelievoFillStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "fill";
  description.Label = "Fill Light";
  description.Help = "Draws fill lights as one smooth light, weaker where the scene hides its "
                     "surroundings.";
  description.Slot = vtkRelievoStageDescription::SURFACES;
  description.Writes = { Resource };
  description.OnByDefault = true;
  description.AddNumber(
    "occlusion", this->Occlusion, [this](double share) { this->SetOcclusion(share); }, 0.0, 1.0, "",
    "Share of the fill lights removed where no sky is visible.");
}

//------------------------------------------------------------------------------
void vtkRelievoFillStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  declaration.OptionalWrites = { Resource };
  declaration.DrawsWithDelegate = true;
  declaration.AnyRaster = true;
  if (FindFillLights(context.Renderer).empty())
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason = "no light is marked as a fill light";
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoFillStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (context.IsPlanned(vtkRelievoResources::Shading))
  {
    this->Explain("idle", "another stage adds the lights, these included");
    return false;
  }
  vtkRelievoAccess::Renderer::FollowCamera(context.Renderer);
  std::vector<glm::dvec3> towards;
  std::vector<glm::dvec3> colors;
  vtkRelievoFillSplice::Structure structure;
  for (const vtkRelievoFrameLight& light : FindFillLights(context.Renderer))
  {
    double from[3];
    double to[3];
    light.Light->GetTransformedPosition(from);
    light.Light->GetTransformedFocalPoint(to);
    const glm::dvec3 direction(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
    structure.Lights.push_back(light.ShaderIndex);
    if (!(glm::length(direction) > 0.0))
    {
      continue; // it shines nowhere
    }
    const double* color = light.Light->GetDiffuseColor();
    towards.push_back(glm::normalize(glm::dmat3(context.View.WorldToView) * direction));
    colors.push_back(light.Light->GetIntensity() * glm::dvec3(color[0], color[1], color[2]));
  }
  in.Coefficients = vtkRelievoFillLight::GetCoefficients(towards, colors);

  // The stage that reads the direct light darkens the rest, fill lights included, by rays. A
  // process knows only the meshes that it draws itself.
  const bool rays = context.IsPlanned(vtkRelievoResources::DirectLight);
  if (this->Occlusion > 0.0 && !rays && !context.Controller)
  {
    const bool isNew =
      in.Grid.Update(in.Meshes.Find(context.Renderer), FindGround(context.Renderer));
    structure.Sky = in.Load(context.Window, isNew);
  }
  if (structure.Sky)
  {
    in.Texture->Activate();
  }
  std::vector<vtkProp*> props;
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = context.State->GetPropArray()[i];
    if (!vtkRelievoShadowCatcher::Is(prop))
    {
      props.push_back(prop);
    }
  }
  in.Splice->Begin(context.Window, props, structure,
    [this, &in, view = context.View, sky = structure.Sky](
      vtkShaderProgram* program) { in.Tell(program, view, sky, this->Occlusion); });
  const int leftOut = structure.Sky ? in.Meshes.GetNumberOfPropsLeftOut() : 0;
  this->Explain("ran",
    std::to_string(structure.Lights.size()) + " lights by nine coefficients" +
      (structure.Sky ? ", with ambient occlusion"
          : rays     ? "; their ambient occlusion is left to the rays of another stage"
          : context.Controller && this->Occlusion > 0.0
          ? ", without ambient occlusion, since several processes draw the scene"
          : "") +
      (leftOut > 0 ? "; " + std::to_string(leftOut) +
            (leftOut == 1 ? " prop hides" : " props hide") + " no sky"
                   : ""));
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoFillStage::Finish(vtkRelievoFrameContext&)
{
  Internals& in = *this->Internal;
  in.Splice->End();
  if (in.Texture)
  {
    in.Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoFillStage::GetBytesHeld()
{
  return this->Internal->Texture ? static_cast<vtkIdType>(this->Internal->Grid.GetTexels().size())
                                 : 0;
}

//------------------------------------------------------------------------------
void vtkRelievoFillStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Splice->ReleaseGraphicsResources(window);
  if (in.Texture && (!window || in.Window == window))
  {
    in.Texture->ReleaseGraphicsResources(in.Window);
    in.Texture = nullptr;
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoFillStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Occlusion: " << this->Occlusion << "\n";
}
