// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The content of each 32-bit word of a G-buffer pixel. All attachments are unsigned integers
// (R32UI, RG32UI or RGBA32UI): no blending, no conversion, no clamping, one readback per
// attachment, and any mix of formats side by side. A word of a format has the bits that a texture
// of that format would have.
#ifndef vtkRelievoGBufferLayout_h
#define vtkRelievoGBufferLayout_h

#include "vtkRelievoGBufferModule.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

struct VTKRELIEVOGBUFFER_EXPORT vtkRelievoGBufferLayout
{
  // Requested channels.
  bool Depth = false;
  bool Normal = false;
  bool GeometricNormal = false;
  bool Albedo = false;
  bool Surface = false;         // lighting mode and colour of surfaces
  bool SurfaceDetail = false;   // and diffuse share, width of highlights, and metal
  bool SurfaceSpecular = false; // and the colour of highlights
  bool SurfacePbr = false;      // some surfaces are PBR
  bool DirectLight = false;     // share of casting lights in a pixel's light
  bool Ids = false;
  bool Places = false; // x and y in eye space, for actors whose own shaders move vertices
  std::map<std::string, int> Lights; // layers of a light's visibility, and the light's number
  std::vector<int> Shadows;          // the lights' numbers in the renderer, ascending
  int NormalFormat = 0;              // vtkRelievoWordFormats::Normals
  int DepthFormat = 0;               // vtkRelievoWordFormats::Depths
  int NormalDepth = 0;               // vtkRelievoWordFormats::NormalDepths
  // Whether attachments have two words instead of four, if these suffice: software OpenGL draws
  // texels of up to 8 bytes faster than larger ones, in several attachments too.
  bool Narrow = false;

  // Position of each channel: its first word, or -1. Set by Arrange().
  int DepthWord = -1;
  int NormalWord = -1;
  int GeometricNormalWord = -1;
  int NormalDepthWord = -1;
  int AlbedoWord = -1;
  int SurfaceWord = -1;
  int SurfaceDetailWord = -1;
  int SurfaceSpecularWord = -1;
  int DirectLightWord = -1;
  int IdWord = -1;
  int PlaceWord = -1;
  int ShadowWord = -1; // two lights per word, 16 bits each

  // The format that NORMAL_AUTO selected. Set by Arrange().
  int ChosenNormalFormat = 0;

  // The background's value of each word. Set by Arrange().
  std::vector<std::uint32_t> Background;

  void Arrange();

  // Outputs of shaders/gbuffer/write.glsl.
  static constexpr int MostAttachments = 5;

  // Whether the sign of a normal can affect a requested channel.
  bool TakesNormals() const
  {
    return this->Normal || this->GeometricNormal || this->Surface || !this->Shadows.empty();
  }

  bool IsEmpty() const { return this->Background.empty(); }
  int GetNumberOfWords() const { return static_cast<int>(this->Background.size()); }
  int GetNumberOfAttachments() const;

  // The words of each attachment but the last, which may have fewer.
  int GetWordsPerAttachment() const;

  // 1, 2 or 4: textures of three words are not renderable on every OpenGL.
  int GetNumberOfChannels(int attachment) const;

  // The light whose visibility the layer shows, or -1: by Lights, else N of shadow_N.
  int GetLight(const std::string& layer) const;

  // Number of words of a normal, and of a normal with depth, by format.
  static int GetNormalWords(int format);
  static int GetNormalDepthWords(int format);

  // The layout as preprocessor defines, for the shaders in shaders/gbuffer.
  std::string GetDefines() const;

  bool operator==(const vtkRelievoGBufferLayout& other) const
  {
    return this->GetDefines() == other.GetDefines() && this->Shadows == other.Shadows;
  }
  bool operator!=(const vtkRelievoGBufferLayout& other) const { return !(*this == other); }
};

#endif
