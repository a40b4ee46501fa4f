// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --grid: lines at round coordinates on the far sides of the scene's box, with numbers.
 */
#ifndef Grid_h
#define Grid_h

#include "AnnotationOptions.h"
#include "LookNames.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
class vtkTextProperty;

namespace look
{
/// Lays itself out for the camera before each picture: lines where sides of the box are behind its
/// contents, numbers at its outer edges. The lines are translucent and unlit, so that they appear
/// in no layer and cast or receive no shadow, and they do not count among the renderer's visible
/// bounds; the numbers are texts over the picture.
class Grid : public vtkCommand
{
public:
  vtkBaseTypeMacro(Grid, vtkCommand);

  /// Adds a grid around these bounds to the renderer, with numbers that contrast with its present
  /// background. `up`: the axis with numbers at the side of the picture. `print`: sizes of text and
  /// lines.
  static vtkSmartPointer<Grid> Add(
    vtkRenderer* renderer, const double bounds[6], int up, const PrintChoice& print);

  /// Removes it from that renderer.
  void Remove(vtkRenderer* renderer);

  vtkActor* GetLines() { return this->Lines; }

  void Execute(vtkObject* renderer, unsigned long, void*) override;

private:
  Grid(const double bounds[6], int up, const std::array<double, 3>& ink, const PrintChoice& print);

  struct Label
  {
    double At = 0.0; // coordinate
    long Index = 0;  // At is this number of steps from 0
    vtkSmartPointer<vtkTextActor> Text;
  };
  struct Axis
  {
    std::vector<Label> Labels;
    Label Title;
  };
  struct Box; // of a text in the picture

  using Sides = std::array<std::array<bool, 2>, 3>; // of each axis, the lower and the upper side

  using Edges = std::array<int, 3>; // of each axis, the edge with numbers, or -1

  Sides FindFarSides(vtkRenderer* renderer) const;
  void DrawLines(const Sides& far, const Edges& numbered);
  void AddThrough(int axis, const std::array<double, 3>& from, bool edge);
  void AddTicks(int axis, int edge, const Sides& far);
  void AddLine(
    const std::array<double, 3>& from, const std::array<double, 3>& to, unsigned char opacity);
  Edges PlaceLabels(vtkRenderer* renderer, const Sides& far);
  int PlaceAxis(vtkRenderer* renderer, int axis, const Sides& far, std::vector<Box>& taken);
  std::array<double, 3> GetCorner(int axis, int edge) const;
  Label MakeLabel(const std::string& text) const;
  Box GetBox(vtkRenderer* renderer, const Label& label) const;

  std::array<std::array<double, 2>, 3> Ends; // of the box
  int Up;
  PrintChoice Print;
  std::array<Axis, 3> Axes;
  Sides DrawnSides{}; // sides that the present lines are on
  Edges DrawnEdges{ -1, -1, -1 };
  vtkNew<vtkTextProperty> Font;
  vtkNew<vtkPolyData> Segments;
  vtkNew<vtkActor> Lines;
  std::array<unsigned char, 3> Ink;
};
}

#endif
