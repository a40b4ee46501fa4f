// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistoryScene.h"

#include <algorithm>

namespace relievoTest
{
namespace
{
double Between(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random() % 1000u) / 999.;
}

const char* const LayerNames[] = { "depth", "normal", "cell", "actor", "albedo", "position",
  "shadow_0", "shadow_2", "shadow_3" };
const int Sizes[][2] = { { 160, 120 }, { 121, 140 }, { 200, 60 } };

}

//------------------------------------------------------------------------------
HistoryState::HistoryState()
{
  const glm::dvec3 places[NumberOfProps] = { { 0., 0., 0. }, { 0.2, 0.8, -0.1 }, { -1.3, 0.7, 0.6 },
    { 1.2, 0.5, 1. }, { -0.4, 1.4, 0.8 }, { 0.9, 1.5, -0.9 }, { -1.6, 0.7, -1.3 } };
  for (int i = 0; i < NumberOfProps; ++i)
  {
    this->Props[i].Position = places[i];
    this->Order.push_back(i);
  }
  const glm::dvec3 lights[NumberOfLights] = { { -3., 4., -2. }, { 2., 5., 1. }, { -1., 3.5, -1.5 },
    { 0.5, 2.6, 1. } };
  for (int i = 0; i < NumberOfLights; ++i)
  {
    this->Lights[i].Position = lights[i];
  }
}

//------------------------------------------------------------------------------
std::string HistoryState::Step(std::mt19937& random)
{
  Prop& prop = this->Props[Pick(random, NumberOfProps)];
  Light& light = this->Lights[Pick(random, NumberOfLights)];
  switch (Pick(random, 34))
  {
    case 0:
      prop.Visible = !prop.Visible;
      return "visibility";
    case 1:
      prop.Position += glm::dvec3(Between(random, -0.3, 0.3), 0., Between(random, -0.3, 0.3));
      return "position";
    case 2:
      prop.Turn += 20.;
      return "turn";
    case 3:
      prop.Opacity = prop.Opacity < 1. ? 1. : 0.5;
      return "opacity";
    case 4:
      prop.Representation = Pick(random, 3);
      return "representation";
    case 5:
      prop.Interpolation = Pick(random, 4);
      return "interpolation";
    case 6:
      prop.Culling = Pick(random, 3);
      return "culling";
    case 7:
      prop.Size = 1. + Pick(random, 4);
      return "size of points and lines";
    case 8:
      prop.Edges = !prop.Edges;
      return "edges";
    case 9:
      prop.Clipped = !prop.Clipped;
      return "clipping plane";
    case 10:
      prop.Casts = Pick(random, 3) - 1;
      return "casting";
    case 11:
      prop.Receives = !prop.Receives;
      return "receiving";
    case 12:
    case 13:
    {
      const int number = Pick(random, NumberOfProps);
      const auto found = std::find(this->Order.begin(), this->Order.end(), number);
      if (found != this->Order.end())
      {
        this->Order.erase(found);
        return "a prop goes";
      }
      this->Order.push_back(number);
      return "a prop comes";
    }
    case 14:
      light.On = !light.On;
      return "light's switch";
    case 15:
      light.Position += glm::dvec3(Between(random, -0.5, 0.5), 0., Between(random, -0.5, 0.5));
      return "light's position";
    case 16:
      light.Attenuation = 0.5 * Pick(random, 3);
      return "light's attenuation";
    case 17:
      light.Casts = !light.Casts;
      return "light's casting";
    case 18:
    case 19:
      this->Eye += glm::dvec3(Between(random, -0.4, 0.4), 0., Between(random, -0.4, 0.4));
      return "a small move of the camera";
    case 20:
      this->Eye = glm::dvec3(Between(random, -4., 4.), Between(random, 0.5, 5.), 5.);
      this->Focus = glm::dvec3(Between(random, -1., 1.), 0.5, 0.);
      return "another camera";
    case 21:
      this->ViewAngle = Between(random, 8., 50.);
      return "view angle";
    case 22:
      this->Parallel = !this->Parallel;
      return "projection";
    case 23:
    {
      const auto& size = Sizes[Pick(random, 3)];
      std::copy(size, size + 2, this->Size);
      return "window's size";
    }
    case 24:
      (Pick(random, 2) ? this->Part : this->Peeling) ^= true;
      return "part of the window or peeling";
    case 25:
      (Pick(random, 2) ? this->Offset : this->Stereo) ^= true;
      return "polygon offset or stereo";
    case 26:
      this->Attached = !this->Attached;
      return "attach or detach";
    case 27:
      this->Shadows = !this->Shadows;
      return "shadows";
    case 28:
      this->Method = Pick(random, 3);
      return "method";
    case 29:
      this->MapSize = 64 << Pick(random, 4);
      return "map size";
    case 30:
      this->Radius = Pick(random, 4);
      return "radius";
    case 31:
      (Pick(random, 2) ? this->Bias : this->Strength) = 0.5 * (1 + Pick(random, 2));
      return "bias or strength";
    case 32:
    {
      const std::string name = LayerNames[Pick(random, 9)];
      const auto found = std::find(this->Layers.begin(), this->Layers.end(), name);
      if (found != this->Layers.end())
      {
        this->Layers.erase(found);
        return "without layer " + name;
      }
      this->Layers.push_back(name);
      return "layer " + name;
    }
    default:
      this->Shown = Pick(random, 2) ? "" : LayerNames[Pick(random, 9)];
      return "shown: " + this->Shown;
  }
}
}
