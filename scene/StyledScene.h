// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene that is updated from changed options: only the differences are set, and the picture
 * equals that of a scene built anew.
 */
#ifndef StyledScene_h
#define StyledScene_h

#include "Frame.h"
#include "Options.h"
#include "Scene.h"
#include "SceneNames.h"
#include "Settings.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkRelievoMaterial.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <array>
#include <map>
#include <string>

class vtkRelievoPass;

namespace reading
{
class Progress;
}

namespace scene
{

///@{
/// The settings that a reader depends on: when this key changes, files are read again. The scene's
/// key covers every setting but the points of lamps, fog and markers.
std::string GetReadingKey(const Settings& settings);
std::string GetSceneKey(const Settings& settings);
///@}

class StyledScene
{
public:
  StyledScene() = default;

  StyledScene(const Scene& scene, const FramePoints& points);

  /// Updates the scene to these options, parsed from the settings; with `keepCamera` the renderer's
  /// camera stays. The renderer must be in a window. Throws UsageError or WorkError; the scene is
  /// then partly updated, and another update completes it.
  void Update(
    const Settings& settings, const RenderOptions& options, bool keepCamera, Progress& progress);

  /// Replaces the points of lamps, fog and markers; the next update shows them.
  void SetPoints(const FramePoints& points);

  /// Whether an update would read no file.
  bool HasSurfaceOf(const Settings& settings) const;

  /// Whether the actor was read from a file, unlike a skeleton, the ground or lines.
  bool IsOfFiles(vtkActor* actor) const;

  /// The names of actors, by their index in the renderer: those of their files. Several actors of
  /// one file share its name.
  std::map<int, std::string> GetObjectNames() const;

  vtkRenderer* GetRenderer() const { return this->Read.Renderer; }
  vtkRelievoPass* GetFrame() const; ///< null: VTK draws the picture without a frame
  Scene& GetScene() { return this->Read; }
  const Scene& GetScene() const { return this->Read; }
  const std::vector<vtkSmartPointer<vtkLight>>& GetFileLights() const { return this->Lights; }
  const FramePoints& GetPoints() const { return this->Points; }
  const RenderOptions& GetOptions() const { return this->Options; } ///< of the last update
  const double* GetBounds() const { return this->Read.Bounds; }

private:
  /// `isStyled`: the scene's lights have not been replaced.
  void SetFrame(const RenderOptions& options, bool isStyled);

  /// An actor's state before options were applied.
  struct Part
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkProperty> Property;
    vtkSmartPointer<vtkTexture> Texture;
    bool SRGB;                                    // whether the texture is sRGB
    vtkSmartPointer<vtkRelievoMaterial> Material; // the model's own material
    bool Colored;
    int ScalarMode, ColorMode, ArrayAccess, ArrayId;
    std::string ArrayName;
    bool OwnRange;
    bool Interpolated; // interpolates scalars before mapping them to colours
  };

  /// Restores the scene as read from its files; surface maps and the skybox stay.
  void RemoveStyle();
  void Restore(const Part& part);

  /// Replaces surface maps and the skybox. If this throws, the old ones stay, and their files are
  /// not read again.
  void ReplaceSurface(const RenderOptions& options, Progress& progress);
  void RemoveSurface();

  Scene Read;
  std::vector<Part> Parts;
  std::vector<vtkSmartPointer<vtkProp>> Props, Unstyled;
  std::vector<vtkSmartPointer<vtkLight>> Lights; // of the files
  FramePoints Points;
  RenderOptions Options;
  std::string Style = "\n", Surface = "\n"; // keys of the last update; at first unlike any key
};
}

#endif
