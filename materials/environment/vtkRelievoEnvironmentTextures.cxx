// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentTextures.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoFormulas.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace vtkRelievoEnvironmentImages;

namespace
{
constexpr float GreatestHalf = 65504.f;
constexpr double Pi = 3.14159265358979323846;

int GetLimit(int projection)
{
  GLint limit = 0;
  glGetIntegerv(projection == Cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &limit);
  return limit;
}

int LevelsOf(int size)
{
  return 1 + static_cast<int>(std::floor(std::log2(size)));
}

void SendFaces(const Pixels& pixels, int level, bool isFloat)
{
  const std::size_t face = static_cast<std::size_t>(pixels.Width) * pixels.Width * 3;
  for (int i = 0; i < 6; ++i)
  {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), level,
      isFloat ? GL_RGB32F : GL_RGB16F, pixels.Width, pixels.Width, 0, GL_RGB, GL_FLOAT,
      pixels.Values.data() + face * static_cast<std::size_t>(i));
  }
}

vtkSmartPointer<vtkTextureObject> MakeTexture(
  vtkOpenGLRenderWindow* window, const Pixels& pixels, int levels, bool isFloat, bool mipmaps)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetInternalFormat(isFloat ? GL_RGB32F : GL_RGB16F);
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetWrapS(
    pixels.Width == 2 * pixels.Height ? vtkTextureObject::Repeat : vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMaxLevel(levels - 1);
  auto* data = const_cast<float*>(pixels.Values.data());
  const auto width = static_cast<unsigned int>(pixels.Width);
  const auto height = static_cast<unsigned int>(pixels.Height);
  bool made = false;
  if (pixels.Slices == 6)
  {
    void* faces[6];
    for (int i = 0; i < 6; ++i)
    {
      faces[i] = data + static_cast<std::size_t>(pixels.Width) * pixels.Width * 3 * i;
    }
    made = texture->CreateCubeFromRaw(width, height, 3, VTK_FLOAT, faces);
  }
  else
  {
    made = texture->Create2DFromRaw(width, height, 3, VTK_FLOAT, data);
  }
  if (!made)
  {
    return nullptr;
  }
  if (mipmaps) // VTK makes them only for cubes
  {
    texture->Activate();
    glGenerateMipmap(pixels.Slices == 6 ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D);
    texture->Deactivate();
  }
  return texture;
}

vtkIdType BytesOf(const Pixels& pixels, bool isFloat)
{
  return static_cast<vtkIdType>(pixels.Values.size()) * (isFloat ? 4 : 2);
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoEnvironmentTextures::Structure::GetDefines() const
{
  std::string defines = "#define RELIEVO_ENVIRONMENT " + std::to_string(this->Projection) + "\n";
  defines += this->Rough ? "#define RELIEVO_ENVIRONMENT_ROUGH\n" : "";
  defines += this->Irradiance ? "#define RELIEVO_IRRADIANCE\n" : "";
  defines += this->Encoded ? "#define RELIEVO_ENCODED\n" : "";
  return defines;
}

//------------------------------------------------------------------------------
vtkRelievoEnvironmentTextures& vtkRelievoEnvironmentTextures::Of(vtkRelievoEnvironment* environment)
{
  return *environment->Textures;
}

//------------------------------------------------------------------------------
vtkRelievoEnvironmentTextures::vtkRelievoEnvironmentTextures(vtkRelievoEnvironment* owner)
  : Owner(owner)
{
}

//------------------------------------------------------------------------------
vtkRelievoEnvironmentTextures::~vtkRelievoEnvironmentTextures()
{
  this->Release(nullptr);
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoEnvironmentTextures::GetLevel(unsigned int level) const
{
  return this->Levels && level < this->Levels->GetNumberOfBlocks()
    ? vtkImageData::SafeDownCast(this->Levels->GetBlock(level))
    : nullptr;
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoEnvironmentTextures::GetSharp() const
{
  return this->Image ? this->Image.GetPointer() : this->GetLevel(0);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoEnvironmentTextures::GetImagesTime() const
{
  vtkMTimeType time = this->ChangeTime.GetMTime();
  auto take = [&time](vtkImageData* image) {
    if (image)
    {
      vtkDataArray* values = image->GetPointData()->GetScalars();
      time = std::max({ time, image->GetMTime(), values ? values->GetMTime() : 0 });
    }
  };
  take(this->Image);
  for (unsigned int i = 0; this->Levels && i < this->Levels->GetNumberOfBlocks(); ++i)
  {
    take(this->GetLevel(i));
  }
  return this->Coefficients ? std::max(time, this->Coefficients->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentTextures::Fail(const std::string& failure)
{
  vtkErrorWithObjectMacro(this->Owner, << failure << ".");
}

//------------------------------------------------------------------------------
bool vtkRelievoEnvironmentTextures::CheckLevels(std::string& failure) const
{
  for (unsigned int i = 0; i < this->Levels->GetNumberOfBlocks(); ++i)
  {
    vtkImageData* level = this->GetLevel(i);
    std::string what = "it is not an image";
    if (level && FindProjection(level, Cube, what))
    {
      const int half = i == 0 ? 0 : this->GetLevel(i - 1)->GetDimensions()[0] / 2;
      if (i == 0 || level->GetDimensions()[0] == half)
      {
        continue;
      }
      std::ostringstream out;
      out << "it is " << level->GetDimensions()[0] << " texels wide, expected " << half
          << ", half of the level before";
      what = out.str();
    }
    failure = "No level " + std::to_string(i) + " of the environment: " + what +
      "; vtkRelievoEnvironmentPrefilter makes levels";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
const vtkRelievoEnvironmentTextures::Structure& vtkRelievoEnvironmentTextures::GetStructure()
{
  const vtkMTimeType time = this->GetImagesTime();
  if (this->LookTime == time)
  {
    this->Is.Encoded = this->Owner->GetGammaCorrect();
    return this->Is;
  }
  this->LookTime = time;
  this->Is = Structure();
  this->Is.Encoded = this->Owner->GetGammaCorrect();
  std::string failure;
  if (this->Levels && this->Levels->GetNumberOfBlocks() > 0)
  {
    this->Is.Rough = this->CheckLevels(failure) && this->Levels->GetNumberOfBlocks() > 1;
    if (!failure.empty())
    {
      this->Fail(failure);
    }
  }
  vtkDataArray* nine = this->Coefficients;
  this->Is.Irradiance =
    nine && nine->GetNumberOfTuples() == 9 && nine->GetNumberOfComponents() == 3;
  if (nine && !this->Is.Irradiance)
  {
    std::ostringstream out;
    out << "No irradiance: its array has " << nine->GetNumberOfTuples() << " tuples of "
        << nine->GetNumberOfComponents() << "; nine of three were expected";
    this->Fail(out.str());
  }
  if (vtkImageData* sharp = this->GetSharp())
  {
    std::string what;
    const int projection = this->Image ? this->Projection : Cube;
    this->Is.Projection = FindProjection(sharp, projection, what);
    if (!what.empty() && (this->Image || failure.empty()))
    {
      this->Fail("No environment: " + what);
    }
  }
  return this->Is;
}

//------------------------------------------------------------------------------
bool vtkRelievoEnvironmentTextures::LoadLevels(Cached& cached)
{
  // Level 0 is the image; level 1 is OpenGL's level 0.
  std::vector<Pixels> all;
  float greatest = 0.f;
  const int limit = GetLimit(Cube);
  for (unsigned int i = 1; i < this->Levels->GetNumberOfBlocks(); ++i)
  {
    all.push_back(Read(this->GetLevel(i), Cube, false, limit));
    greatest = std::max(greatest, all.back().Greatest);
  }
  const bool isFloat = greatest > GreatestHalf;
  cached.Levels = MakeTexture(cached.Window, all[0], static_cast<int>(all.size()), isFloat, false);
  if (!cached.Levels)
  {
    return false;
  }
  cached.Bytes += BytesOf(all[0], isFloat);
  cached.Levels->Activate();
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    SendFaces(all[i], static_cast<int>(i), isFloat);
    cached.Bytes += BytesOf(all[i], isFloat);
  }
  cached.Levels->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoEnvironmentTextures::Load(Cached& cached)
{
  cached.Image = nullptr;
  cached.Levels = nullptr;
  cached.Bytes = 0;
  vtkImageData* sharp = this->GetSharp();
  const int* size = sharp->GetDimensions();
  const int limit = GetLimit(this->Is.Projection);
  const bool sRGB = this->Image && this->SRGB;
  const Pixels pixels = Read(sharp, this->Is.Projection, sRGB, limit);
  if (pixels.Width != size[0])
  {
    vtkWarningWithObjectMacro(this->Owner,
      "The environment's " << size[0] << " x " << size[1] << " texels are more than this OpenGL's "
                           << limit << ": reduced to " << pixels.Width << " x " << pixels.Height
                           << ".");
  }
  const double width = pixels.Width;
  const double details[4] = { 1., width / (2. * Pi), width / 2., width / 4. };
  cached.Detail = details[this->Is.Projection];
  const bool isFloat = pixels.Greatest > GreatestHalf;
  cached.Image = MakeTexture(cached.Window, pixels, LevelsOf(pixels.Width), isFloat, true);
  cached.Bytes = BytesOf(pixels, isFloat) * 4 / 3;
  return cached.Image && (!this->Is.Rough || this->LoadLevels(cached));
}

//------------------------------------------------------------------------------
bool vtkRelievoEnvironmentTextures::Activate(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, double roughness)
{
  if (!window || !this->GetStructure().Projection)
  {
    return false;
  }
  this->All.erase(std::remove_if(this->All.begin(), this->All.end(),
                    [](const Cached& cached) { return !cached.Window; }),
    this->All.end());
  auto cached = std::find_if(this->All.begin(), this->All.end(),
    [window](const Cached& one) { return one.Window == window; });
  if (cached == this->All.end())
  {
    cached = this->All.insert(this->All.end(), Cached());
    cached->Window = window;
  }
  if (cached->IsLost())
  {
    *cached = Cached();
    cached->Window = window;
  }
  if (cached->Time != this->LookTime)
  {
    cached->Time = this->LookTime;
    if (!this->Load(*cached))
    {
      cached->Image = nullptr;
      this->Fail("No environment: OpenGL cannot make a texture of it");
    }
  }
  if (!cached->Image)
  {
    return false;
  }
  window->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  cached->Image->Activate();
  program->SetUniformi("relievoEnvironmentImage", cached->Image->GetTextureUnit());
  program->SetUniformf("relievoEnvironmentDetail", static_cast<float>(cached->Detail));
  if (cached->Levels)
  {
    const auto levels = static_cast<int>(this->Levels->GetNumberOfBlocks());
    const double level = relievo::f64::relievoPrefilterLevel(roughness, levels);
    const float uses[2] = { static_cast<float>(std::min(level, 1.)),
      static_cast<float>(std::max(level - 1., 0.)) };
    cached->Levels->Activate();
    program->SetUniformi("relievoEnvironmentLevels", cached->Levels->GetTextureUnit());
    program->SetUniform2f("relievoEnvironmentLevel", uses);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentTextures::Deactivate(vtkOpenGLRenderWindow* window)
{
  for (const Cached& cached : this->All)
  {
    if (cached.Window && cached.Window == window)
    {
      for (vtkTextureObject* texture : { cached.Image.GetPointer(), cached.Levels.GetPointer() })
      {
        if (texture)
        {
          texture->Deactivate();
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoEnvironmentTextures::GetBytes()
{
  vtkIdType bytes = 0;
  for (const Cached& cached : this->All)
  {
    bytes += cached.Window && cached.Image && !cached.IsLost() ? cached.Bytes : 0;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentTextures::Release(vtkWindow* window)
{
  for (Cached& cached : this->All)
  {
    if (cached.Window && (!window || cached.Window == window))
    {
      for (vtkTextureObject* texture : { cached.Image.GetPointer(), cached.Levels.GetPointer() })
      {
        if (texture)
        {
          texture->ReleaseGraphicsResources(cached.Window);
        }
      }
      cached = Cached();
    }
  }
}
