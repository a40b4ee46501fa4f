// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoMarkers
 * @brief Markers on surfaces, around points of data and around actors
 * (vtkRelievoMarkersStage::AddPoints).
 *
 * Each point of the input is a marker; its point arrays `radius`, `width`, `reach`, `opacity` and
 * `color` (SetArray selects others) give it its own values, and the values set here apply to points
 * without arrays, and to actors. Every visible surface within the radius of a point is coloured;
 * for an actor the distance is that from its oriented bounding box.
 *
 * Shapes:
 * - RING (default): from `width` below the radius to the radius.
 * - GLOW: (1 - (distance / radius)^2)^2.
 * - DISC: everything within the radius.
 * - SHADOW: a soft, dark blob on surfaces below that face up, cast by a ball of the radius, or by
 *   the actor's box grown by it. Its opacity is (1 - (d / r)^2)^2 at distance d from the axis,
 *   where the shadow begins, and fades linearly with the height to 0 at `reach` radii. Nothing
 *   blocks it: it falls on every surface below. The colour is not used.
 *
 * Points whose radius or opacity (a ring's width, a shadow's reach) is 0 or less have no effect and
 * are counted (GetNumberLeftOut); the radius of an actor's shadow may be 0.
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
  /** Shape of the markers; see the class. Default RING. */
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
  /** Width of a ring as a share of its radius, up to 1. Default 0.2. */
  void SetWidth(double width);
  double GetWidth() const { return this->GetForAll(1)[0]; }
  ///@}

  ///@{
  /** Length of a shadow downwards, in radii. Default 4. */
  void SetReach(double reach);
  double GetReach() const { return this->GetForAll(2)[0]; }
  ///@}

  ///@{
  /** Opacity of the colour, or of a shadow's black, up to 1. Default 0.8. */
  void SetOpacity(double opacity);
  double GetOpacity() const { return this->GetForAll(3)[0]; }
  ///@}

  ///@{
  /** Linear RGB, default orange (1, 0.5, 0). Arrays of bytes range from 0 to 255. */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) { this->SetColor(color[0], color[1], color[2]); }
  void GetColor(double color[3]) const;
  ///@}

  ///@{
  /** Direction that shadows fall from: up, or towards the light. Any length; default (0, 1, 0). */
  void SetUp(double x, double y, double z);
  void SetUp(const double up[3]) { this->SetUp(up[0], up[1], up[2]); }
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Adds an actor or another prop to mark, once; its marker follows its moves and changes.
   * Invisible props have no marker. The list is local to this process.
   */
  void AddActor(vtkProp3D* actor);
  void RemoveActor(vtkProp3D* actor);
  void RemoveAllActors();
  int GetNumberOfActors();
  vtkProp3D* GetActor(int i);
  ///@}

#ifndef __VTK_WRAP__
  // The box around an actor: orthogonal unit axes, and half lengths along them.
  struct Box
  {
    double Center[3];
    double Axes[3][3];
    double Half[3];
  };

  // The boxes of the actors that are visible now and have an extent.
  std::vector<Box> GetBoxes();

  // The values of actors' markers, laid out as in rows after the position; false if they have no
  // effect.
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
