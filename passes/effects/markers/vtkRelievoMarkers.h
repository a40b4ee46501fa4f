// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoMarkers
 * @brief Markers on surfaces, around points of data and around actors
 * (vtkRelievoMarkersStage::AddPoints).
 *
 * Each point of the input is one; its point arrays `radius`, `width`, `reach`, `opacity` and
 * `color` (SetArray takes others) give it its own values, and the values set here are for points
 * without, and for actors. Whatever surface is seen within the radius of a point is coloured;
 * distances of an actor are those from the box around it, which turns and moves with it.
 *
 * Shapes:
 * - RING (default): from `width` below the radius to the radius.
 * - GLOW: (1 - (distance / radius)^2)^2.
 * - DISC: all within the radius.
 * - SHADOW: a soft, dark blob on whatever lies below and faces up, as of something round with the
 *   radius, or of the actor's box grown by it. It is (1 - (d / r)^2)^2 at distance d from the axis,
 *   where it begins, and fades in proportion to the height, to nothing at `reach` radii. Nothing
 *   is in its way: it falls on all that lies below. The colour is not used.
 *
 * A point whose radius or opacity (a ring's width, a shadow's reach) is 0 or less has no effect,
 * and is counted (GetNumberLeftOut); the radius of an actor's shadow may be 0.
 */
#ifndef vtkRelievoMarkers_h
#define vtkRelievoMarkers_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoPointValues.h"

#include <memory> // for the actors
#include <vector> // for boxes

class vtkProp3D;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoMarkers : public vtkRelievoPointValues
{
public:
  static vtkRelievoMarkers* New();
  vtkTypeMacro(vtkRelievoMarkers, vtkRelievoPointValues);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    RING = 0,
    GLOW = 1,
    DISC = 2,
    SHADOW = 3
  };

  ///@{
  /** What is drawn; see the class. Default RING. */
  vtkSetClampMacro(Shape, int, RING, SHADOW);
  vtkGetMacro(Shape, int);
  void SetShapeToRing() { this->SetShape(RING); }
  void SetShapeToGlow() { this->SetShape(GLOW); }
  void SetShapeToDisc() { this->SetShape(DISC); }
  void SetShapeToShadow() { this->SetShape(SHADOW); }
  ///@}

  ///@{
  /** World units, default 1. */
  void SetRadius(double radius);
  double GetRadius() const { return this->GetForAll(0)[0]; }
  ///@}

  ///@{
  /** Of a ring, as a share of its radius, up to 1. Default 0.2. */
  void SetWidth(double width);
  double GetWidth() const { return this->GetForAll(1)[0]; }
  ///@}

  ///@{
  /** How far down a shadow falls, in radii. Default 4. */
  void SetReach(double reach);
  double GetReach() const { return this->GetForAll(2)[0]; }
  ///@}

  ///@{
  /** Of the colour, or of a shadow's black, up to 1. Default 0.8. */
  void SetOpacity(double opacity);
  double GetOpacity() const { return this->GetForAll(3)[0]; }
  ///@}

  ///@{
  /** Linear RGB, default orange (1, 0.5, 0). Arrays of bytes are 0 to 255. */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) { this->SetColor(color[0], color[1], color[2]); }
  void GetColor(double color[3]) const;
  ///@}

  ///@{
  /** Where shadows fall from: up, or the way to the light. Any length; default (0, 1, 0). */
  void SetUp(double x, double y, double z);
  void SetUp(const double up[3]) { this->SetUp(up[0], up[1], up[2]); }
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Actors, or other props, to mark, each once: followed as they move and change. Invisible ones
   * have no marker. They are this process's alone.
   */
  void AddActor(vtkProp3D* actor);
  void RemoveActor(vtkProp3D* actor);
  void RemoveAllActors();
  int GetNumberOfActors();
  vtkProp3D* GetActor(int i);
  ///@}

#ifndef __VTK_WRAP__
  // What is around an actor: orthogonal axes of length 1, and half lengths along them.
  struct Box
  {
    double Center[3];
    double Axes[3][3];
    double Half[3];
  };

  // Of the actors that are visible now, and have any extent.
  std::vector<Box> GetBoxes();

  // The values for all, as rows have them after the place; false if they have no effect.
  bool GetValuesForActors(double values[7]) const;
#endif

protected:
  vtkRelievoMarkers();
  ~vtkRelievoMarkers() override;

  bool HasEffect(const double* row) const override;

  int Shape = RING;
  double Up[3] = { 0.0, 1.0, 0.0 };

private:
  vtkRelievoMarkers(const vtkRelievoMarkers&) = delete;
  void operator=(const vtkRelievoMarkers&) = delete;

  bool IsVisible(const double* values) const;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
