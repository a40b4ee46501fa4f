// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene that was read, shown as options say: only what changed is set anew, and the picture is
 * that of a scene which was never shown otherwise.
 */
#ifndef DressedScene_h
#define DressedScene_h

#include "Frame.h"
#include "Options.h"
#include "Scene.h"
#include "Settings.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkRelievoMaterial.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <array>
#include <string>

class vtkRelievoPass;

namespace scene
{
class Progress;

///@{
/// What of the settings a reader needs: when this changes, files are read again. The scene's part
/// is all but the points of lamps, fog and markers.
std::string GetReadingKey(const Settings& settings);
std::string GetSceneKey(const Settings& settings);
///@}

class DressedScene
{
public:
  DressedScene() = default;

  DressedScene(const Scene& scene, const FramePoints& points);

  /// Shows the scene by these options, which are those of the settings; `keepCamera`: but with
  /// the renderer's camera. The renderer must be in a window. Throws UsageError or WorkError, and
  /// leaves the scene between what it was and what it was to be: another update mends it.
  void Update(
    const Settings& settings, const RenderOptions& options, bool keepCamera, Progress& progress);

  /// Other points for the lamps, fog and markers of the options that are shown next.
  void SetPoints(const FramePoints& points);

  /// Whether an update reads no file.
  bool IsDressedAlike(const Settings& settings) const;

  /// Whether a colour bar that is shown was made for another size of the window.
  bool IsBarOutgrown() const;

  /// Whether it is an actor of the files, and no skeleton, ground or lines.
  bool IsOfFiles(vtkActor* actor) const;

  vtkRenderer* GetRenderer() const { return this->Read.Renderer; }
  vtkRelievoPass* GetFrame() const; ///< null: the picture is VTK's own
  Scene& GetScene() { return this->Read; }
  const Scene& GetScene() const { return this->Read; }
  const std::vector<vtkSmartPointer<vtkLight>>& GetFileLights() const { return this->Lights; }
  const FramePoints& GetPoints() const { return this->Points; }
  const RenderOptions& GetOptions() const { return this->Options; } ///< that are shown
  const double* GetBounds() const { return this->Read.Bounds; }

private:
  void SetFrame(const RenderOptions& options);

  // What an actor was before it was dressed.
  struct Part
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkProperty> Property;
    vtkSmartPointer<vtkTexture> Texture;
    bool SRGB;                                    // of the texture
    vtkSmartPointer<vtkRelievoMaterial> Material; // of a model that brings one
    bool Colored;
    int ScalarMode, ColorMode, ArrayAccess, ArrayId;
    std::string ArrayName;
    bool OwnRange;
    bool Interpolated; // scalars, before they are colours
  };

  // Brings the scene back to how it was read; what surfaces wear stays, and the sky.
  void Undress();
  void Restore(const Part& part);

  // Sets what surfaces wear, and the sky, instead of what there was; that stays, without its files
  // being read again, where this throws.
  void Wear(const RenderOptions& options, Progress& progress);
  void TakeOff();

  Scene Read;
  std::vector<Part> Parts;
  std::vector<vtkSmartPointer<vtkProp>> Props, Kept;
  std::vector<vtkSmartPointer<vtkLight>> Lights; // of the files
  FramePoints Points;
  RenderOptions Options;
  std::string Dress = "\n", Surface = "\n"; // the words it was made of; at first like no words
  std::array<int, 2> BarSize{};             // of the window that the scalar bar was made for
};
}

#endif
