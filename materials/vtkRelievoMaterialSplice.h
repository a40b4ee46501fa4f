// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splices a material into VTK's shaders.
#ifndef vtkRelievoMaterialSplice_h
#define vtkRelievoMaterialSplice_h

#include <string>

namespace vtkRelievoMaterialSplice
{
struct Structure
{
  bool NormalMap = false;
  bool HeightMap = false;
  int Method = 0; // of relief; 0: heights give normals only
  bool SelfShadow = false;
  bool DepthCorrection = false;
  bool Clip = false;
  bool Cut = false; // by vtkRelievoCutoff

  bool operator==(const Structure& other) const
  {
    return this->NormalMap == other.NormalMap && this->HeightMap == other.HeightMap &&
      this->Method == other.Method && this->SelfShadow == other.SelfShadow &&
      this->DepthCorrection == other.DepthCorrection && this->Clip == other.Clip &&
      this->Cut == other.Cut;
  }
};

void Mark(std::string& vertex, std::string& geometry, std::string& fragment);

// tangents: the mesh has tangents. Returns an error message, or an empty string.
std::string Fill(std::string& vertex, std::string& geometry, std::string& fragment,
  const Structure& structure, bool tangents);
}

#endif
