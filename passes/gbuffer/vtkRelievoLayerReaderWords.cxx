// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers that are a part of a word as it is.
#include "vtkRelievoLayerReader.h"

#include "vtkFloatArray.h"
#include "vtkLightCollection.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoRows.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadAlbedo()
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetNumberOfComponents(4);
  array->SetNumberOfTuples(this->GetNumberOfPixels());
  unsigned char* out = array->GetPointer(0);
  int stride = 0;
  const std::uint32_t* words = this->GetWords(this->Layout.AlbedoWord, stride);
  const vtkIdType width = this->Region[2];
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        out[4 * i + k] = static_cast<unsigned char>(words[i * stride] >> (8 * k));
      }
    }
  });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkRelievoLayerReader::ReadShadow(int light, std::string& wrong)
{
  const int lights = this->Renderer ? this->Renderer->GetLights()->GetNumberOfItems() : 0;
  if (light >= lights)
  {
    wrong = "the renderer has " + std::to_string(lights) + (lights == 1 ? " light" : " lights") +
      ", counted from 0";
    return nullptr;
  }
  const std::vector<int>& shadows = this->Layout.Shadows;
  const int place =
    static_cast<int>(std::lower_bound(shadows.begin(), shadows.end(), light) - shadows.begin());
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfTuples(this->GetNumberOfPixels());
  float* out = array->GetPointer(0);
  int stride = 0;
  const std::uint32_t* words = this->GetWords(this->Layout.ShadowWord + place / 2, stride);
  const int shift = 16 * (place % 2);
  const vtkIdType width = this->Region[2];
  vtkRelievoForRows(this->Region[3], this->Region[2], [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from * width; i < to * width; ++i)
    {
      out[i] = static_cast<float>((words[i * stride] >> shift) & 0xffffu) / 65535.0f;
    }
  });
  return array;
}
