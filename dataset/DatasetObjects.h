// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The objects of a data set: actors of a renderer, several by one name, or blocks of their data.
 */
#ifndef DatasetObjects_h
#define DatasetObjects_h

#include "vtkBoundingBox.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkProp;
class vtkRenderer;

namespace scene
{
struct DatasetObject
{
  std::string Name;
  vtkSmartPointer<vtkMatrix4x4> Pose; ///< from its data to the world; the first of several
};

/// A pose as a rotation, row by row, and a place: what its matrix scales or mirrors belongs to the
/// object.
void GetRigidPose(vtkMatrix4x4* pose, double rotation[9], double place[3]);

class DatasetObjects
{
public:
  /// Visible actors; those without a name in `names` (by number) are called actor_NUMBER, those
  /// with an empty one only hide others.
  DatasetObjects(vtkRenderer* renderer, const std::map<int, std::string>& names, bool blocks);

  const std::vector<DatasetObject>& Get() const { return this->Objects; }

  /// The corners in the world of boxes around the parts of an object.
  std::vector<std::array<double, 3>> GetCorners(int object) const;

  /// Around the objects: where there are none, around all that is shown.
  vtkBoundingBox GetBounds() const;

  /// Around all that has a depth.
  vtkBoundingBox GetOpaqueBounds() const;

  /// The object of these values of the layers `actor` and `block`; -1: none.
  int Find(int actor, int block) const;

  /// While it lives, the renderer shows this object and no other mesh.
  class Alone
  {
  public:
    Alone(const DatasetObjects& objects, int object);
    ~Alone();
    Alone(const Alone&) = delete;
    void operator=(const Alone&) = delete;

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
  bool Has(int object, vtkActor* actor) const;

  struct Part
  {
    vtkActor* Actor;
    int Number;          // of the actor
    int Block;           // -1: all
    vtkDataObject* Data; // of the block
    int Object;          // -1: none
    vtkSmartPointer<vtkMatrix4x4> Pose;
  };
  static std::vector<std::array<double, 3>> GetCorners(const Part& part);

  vtkRenderer* Renderer;
  std::vector<Part> Parts;
  std::vector<DatasetObject> Objects;
  std::map<std::pair<int, int>, int> Numbers; // objects by actor and block
};
}

#endif
