// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Images of a surface's material, whichever file names them: OBJ's libraries, PLY, glTF or another
 * model.
 */
#ifndef MaterialMaps_h
#define MaterialMaps_h

#include "ReadingNames.h"
#include "vtkImageData.h"
#include "vtkRelievoMaterial.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <array>
#include <map>
#include <optional>
#include <tuple>

class vtkActor;

namespace reading
{
struct MaterialMaps
{
  vtkSmartPointer<vtkImageData> Color; ///< null: none
  /// The colours' texture coordinates are multiplied by the scale, then the offset is added.
  std::array<double, 2> Scale = { 1.0, 1.0 };
  std::array<double, 2> Offset = { 0.0, 0.0 };
  vtkSmartPointer<vtkImageData> Normals; ///< null: none
  double NormalStrength = 1.0;
  bool NormalsRepeat = true;
  std::optional<double> Cutoff; ///< the alpha below which the surface is cut out, 0: nowhere; none:
                                ///< as the colours have it
};

/// Puts them on actors, which share textures and materials where these are alike.
class MaterialPainter
{
public:
  void Put(vtkActor* actor, const MaterialMaps& maps);

private:
  using TextureKey =
    std::tuple<vtkSmartPointer<vtkImageData>, std::array<double, 2>, std::array<double, 2>>;
  using MaterialKey = std::tuple<vtkSmartPointer<vtkImageData>, double, double, bool>;

  vtkSmartPointer<vtkTexture> GetTexture(const MaterialMaps& maps);
  vtkSmartPointer<vtkRelievoMaterial> GetMaterial(const MaterialMaps& maps, double cutoff);

  // By image, scale and offset; by normal map, its strength, cutoff, and whether it repeats.
  std::map<TextureKey, vtkSmartPointer<vtkTexture>> Textures;
  std::map<MaterialKey, vtkSmartPointer<vtkRelievoMaterial>> Materials;
};
}

#endif
