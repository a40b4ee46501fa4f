// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rectangles and texts in pixels over a picture, for bars and legends. A prop collects them anew in
// each frame; those that have not changed keep their buffers and textures.
#ifndef vtkRelievoOverlayPen_h
#define vtkRelievoOverlayPen_h

#include "vtkNew.h"
#include "vtkRelievoEffectsModule.h" // for the export macro

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkActor2D;
class vtkPolyData;
class vtkTextActor;
class vtkTextProperty;
class vtkViewport;
class vtkWindow;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoOverlayPen
{
public:
  using Color = std::array<double, 3>; // as on displays, 0 to 1

  vtkRelievoOverlayPen();
  ~vtkRelievoOverlayPen();

  // Starts without texts and lines; the viewport must be in a window.
  void Begin(vtkViewport* viewport);

  // Width and height of a text; `size` is the font's height in pixels.
  std::array<double, 2> Measure(const std::string& text, double size);

  // Left, bottom, right, top.
  void AddRectangle(const std::array<double, 4>& box, const Color& color, double opacity = 1.0);

  // The left bottom corner of the text, with an edge of another colour as wide as `halo`.
  void AddText(const std::array<double, 2>& at, const std::string& text, double size,
    const Color& color, const Color& edge, double halo);

  // Draws rectangles in the order in which they were added, then the texts.
  void Draw();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkRelievoOverlayPen(const vtkRelievoOverlayPen&) = delete;
  void operator=(const vtkRelievoOverlayPen&) = delete;

  struct Rectangle
  {
    std::array<double, 4> Box;
    std::array<unsigned char, 4> Color;
    bool operator==(const Rectangle& other) const
    {
      return this->Box == other.Box && this->Color == other.Color;
    }
  };
  struct Text
  {
    vtkNew<vtkTextActor> Ink, Edge;
    std::array<double, 2> At;
    double Halo;
  };
  int GetFontSize(double size) const;

  vtkViewport* Viewport = nullptr;
  int DPI = 72;
  std::vector<Rectangle> Rectangles, Drawn;
  std::vector<std::unique_ptr<Text>> Texts;
  std::size_t Written = 0; // texts of this frame
  vtkNew<vtkTextProperty> Measured;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkActor2D> Shapes;
};

#endif
