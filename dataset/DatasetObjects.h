// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The objects of a data set: actors (several of one name form one object), blocks of their data,
 * and volumes that count as surfaces (vtkRelievoVolumesStage::Solid).
 */
#ifndef DatasetObjects_h
#define DatasetObjects_h

#include "DatasetNames.h"
#include "vtkBoundingBox.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkProp;
class vtkRenderer;

namespace dataset
{
struct DatasetObject
{
  std::string Name;
  vtkSmartPointer<vtkMatrix4x4> Pose; ///< data to world; of the first of several actors
};

/// A matrix as rotation (row by row) and translation; its scale and mirroring belong to the object.
void GetRigidPose(vtkMatrix4x4* pose, double rotation[9], double place[3]);

class DatasetObjects
{
public:
  /// Takes the visible actors. One without a name in `names` (by number) is called actor_NUMBER;
  /// one with an empty name only hides others. Solid volumes are called volume_NUMBER.
  DatasetObjects(vtkRenderer* renderer, const std::map<int, std::string>& names, bool blocks);

  const std::vector<DatasetObject>& Get() const { return this->Objects; }

  /// World corners of the boxes around an object's parts.
  std::vector<std::array<double, 3>> GetCorners(int object) const;

  /// The number of pixels that an object may cover around its boxes; none if it may be anywhere.
  std::optional<double> GetBorder(int object) const;

  /// Bounds of the objects; without objects, of all visible props.
  vtkBoundingBox GetBounds() const;

  /// Bounds of all props with a depth.
  vtkBoundingBox GetOpaqueBounds() const;

  /// The object for values of the layers `actor` and `block`; -1: none.
  int Find(int actor, int block) const;

  /// Whether volumes are objects, and the object of a value of the layer `volume`; -1: none.
  bool HasVolumes() const { return !this->Volumes.empty(); }
  int FindVolume(int volume) const;

  /// While it lives, the renderer shows these objects only.
  class Alone
  {
  public:
    Alone(const DatasetObjects& objects, const std::vector<int>& shown);
    ~Alone();
    Alone(const Alone&) = delete;
    void operator=(const Alone&) = delete;

    /// Whether the renderer shows nothing else anyway.
    bool IsWhole() const { return this->Hidden.empty() && this->Blocks.empty(); }

  private:
    struct Block
    {
      vtkActor* Actor;
      vtkDataObject* Data;
      bool Has, Visible;
    };
    std::vector<vtkProp*> Hidden;
    std::vector<Block> Blocks;
  };

private:
  bool Has(const std::vector<int>& objects, vtkActor* actor) const;

  struct Part
  {
    vtkActor* Actor;
    int Number;          // actor's number
    int Block;           // -1: all
    vtkDataObject* Data; // the block's data
    int Object;          // -1: none
    vtkSmartPointer<vtkMatrix4x4> Pose;
  };
  struct Volume
  {
    vtkProp* Prop;
    const double* Bounds; // of the data
    int Object;
    vtkSmartPointer<vtkMatrix4x4> Pose;
  };
  static std::vector<std::array<double, 3>> GetCorners(const Part& part);
  void AddVolumes();

  vtkRenderer* Renderer;
  std::vector<Part> Parts;
  std::map<int, Volume> Volumes; // by the volume's number
  std::vector<DatasetObject> Objects;
  std::map<std::pair<int, int>, int> Numbers; // object numbers by actor and block
};
}

#endif
