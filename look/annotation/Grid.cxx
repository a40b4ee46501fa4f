// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grid.h"

#include "Triples.h"
#include "vtkRelievoAnnotation.h"
#include "vtkRelievoVTKVersions.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace look
{
using vtkRelievoAnnotation::GetInk;
using vtkRelievoAnnotation::RoundDown;

namespace
{
constexpr double ManySteps = 6.0; // least number along the longest side
constexpr double FewSteps = 3.0;  // along a short side
constexpr double Thin = 0.03;     // share of the longest side: thinner sides get no numbers
constexpr double Outside = 5e-5;  // share of the diagonal between scene and box, above the ground
constexpr double Behind = 2e-3;   // the same along the axis of a flat scene
constexpr double Tick = 0.012;    // share of the longest side
constexpr unsigned char Edge = 150, Inner = 60; // opacities of lines
constexpr int LinesOfText = 45;                 // lines per picture height, about
constexpr int SmallestText = 9;                 // pixels
constexpr double FineLine = 900.0;              // picture height in pixels per unit of line width

int GetShorterSide(vtkRenderer* renderer)
{
  const int* size = renderer->GetSize();
  return std::min(size[0], size[1]);
}

//------------------------------------------------------------------------------
// How many times as large VTK draws texts in a window that draws tiles of a picture.
int GetMagnification(vtkRenderWindow* window)
{
  return RELIEVO_VTK_MAGNIFIED_TEXTS ? window->GetTileScale()[1] : 1;
}

//------------------------------------------------------------------------------
// The lower left pixel of the part of the renderer's picture that is drawn. Not 0 in tiles.
std::array<double, 2> GetTileOrigin(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  int size[2];
  int origin[2]; // in the tile
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  double tile[4];
  window->GetTileViewport(tile);
  std::array<double, 2> place{};
  for (int i = 0; i < 2; ++i)
  {
    place[static_cast<std::size_t>(i)] =
      std::round(tile[i] * window->GetSize()[i]) + origin[i] - renderer->GetOrigin()[i];
  }
  return place;
}

//------------------------------------------------------------------------------
// Projects points to pixels of the renderer. The camera of a tile sees only that.
class Projection
{
public:
  explicit Projection(vtkRenderer* renderer)
    : Size{ static_cast<double>(renderer->GetSize()[0]),
      static_cast<double>(renderer->GetSize()[1]) }
    , Origin(GetTileOrigin(renderer))
    , Matrix(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        renderer->GetTiledAspectRatio(), -1.0, 1.0))
  {
    renderer->GetTiledSize(&this->Tile[0], &this->Tile[1]);
  }

  /// None for points beside or behind the camera.
  std::optional<std::array<double, 2>> operator()(const std::array<double, 3>& point) const
  {
    const double from[4] = { point[0], point[1], point[2], 1.0 };
    double to[4];
    this->Matrix->MultiplyPoint(from, to);
    if (to[3] <= 0.0)
    {
      return std::nullopt;
    }
    return std::array<double, 2>{ this->Origin[0] + 0.5 * (to[0] / to[3] + 1.0) * this->Tile[0],
      this->Origin[1] + 0.5 * (to[1] / to[3] + 1.0) * this->Tile[1] };
  }

  bool IsInside(const std::array<double, 2>& pixel) const
  {
    return pixel[0] >= 0.0 && pixel[0] <= this->Size[0] && pixel[1] >= 0.0 &&
      pixel[1] <= this->Size[1];
  }

  const std::array<double, 2> Size;

private:
  const std::array<double, 2> Origin;
  std::array<int, 2> Tile{};
  vtkMatrix4x4* Matrix;
};
}

//------------------------------------------------------------------------------
// At is the text's left bottom corner.
struct Grid::Box
{
  std::array<double, 2> At{}, Size{};

  bool IsApart(const Box& other) const
  {
    const auto isBefore = [](const Box& a, const Box& b, std::size_t i) {
      return a.At[i] + a.Size[i] + 3.0 <= b.At[i];
    };
    return isBefore(*this, other, 0) || isBefore(other, *this, 0) || isBefore(*this, other, 1) ||
      isBefore(other, *this, 1);
  }

  // Places a text beside a point in a unit direction, with a gap; within the picture.
  void Place(const std::array<double, 2>& point, const std::array<double, 2>& out, double gap,
    const std::array<double, 2>& picture)
  {
    const double reach = this->GetReach(out);
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double middle = point[i] + (gap + reach) * out[i];
      const double last = std::max(1.0, picture[i] - this->Size[i] - 1.0);
      this->At[i] = std::round(std::clamp(middle - 0.5 * this->Size[i], 1.0, last));
    }
  }

  double GetReach(const std::array<double, 2>& out) const
  {
    return 0.5 * (this->Size[0] * std::abs(out[0]) + this->Size[1] * std::abs(out[1]));
  }
};

//------------------------------------------------------------------------------
vtkSmartPointer<Grid> Grid::Add(
  vtkRenderer* renderer, const double bounds[6], int up, const PrintChoice& print)
{
  const auto grid = vtkSmartPointer<Grid>::Take(new Grid(bounds, up, GetInk(renderer), print));
  renderer->AddActor(grid->Lines);
  for (const Axis& axis : grid->Axes)
  {
    for (const Label& label : axis.Labels)
    {
      renderer->AddViewProp(label.Text);
    }
    renderer->AddViewProp(axis.Title.Text);
  }
  renderer->AddObserver(vtkCommand::StartEvent, grid);
  return grid;
}

//------------------------------------------------------------------------------
void Grid::Remove(vtkRenderer* renderer)
{
  renderer->RemoveObserver(this);
  renderer->RemoveActor(this->Lines);
  for (const Axis& axis : this->Axes)
  {
    for (const Label& label : axis.Labels)
    {
      renderer->RemoveViewProp(label.Text);
    }
    renderer->RemoveViewProp(axis.Title.Text);
  }
}

//------------------------------------------------------------------------------
Grid::Grid(
  const double bounds[6], int up, const std::array<double, 3>& ink, const PrintChoice& print)
  : Up(up)
  , Print(print)
  , Ink{ static_cast<unsigned char>(255.0 * ink[0]), static_cast<unsigned char>(255.0 * ink[1]),
    static_cast<unsigned char>(255.0 * ink[2]) }
{
  vtkRelievoAnnotation::SetFont(this->Font);
  this->Font->SetColor(ink[0], ink[1], ink[2]);
  const std::array<double, 3> sides = { bounds[1] - bounds[0], bounds[3] - bounds[2],
    bounds[5] - bounds[4] };
  const double longest = *std::max_element(sides.begin(), sides.end());
  const double common = longest > 0.0 ? RoundDown(longest / ManySteps) : 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double side = sides[axis];
    const double beyond = Length(sides) * (side > 1e-6 * longest ? Outside : Behind);
    this->Ends[axis] = { bounds[2 * axis] - beyond, bounds[2 * axis + 1] + beyond };
    this->Axes[axis].Title = this->MakeLabel(std::string(1, "xyz"[axis]));
    if (longest <= 0.0 || side < Thin * longest)
    {
      continue;
    }
    const double step = side >= FewSteps * common ? common : RoundDown(side / FewSteps);
    const double tolerance = 1e-6;
    const auto first = std::lround(std::ceil(bounds[2 * axis] / step - tolerance));
    const auto last = std::lround(std::floor(bounds[2 * axis + 1] / step + tolerance));
    std::vector<double> values;
    for (long index = first; index <= last; ++index)
    {
      values.push_back(static_cast<double>(index) * step);
    }
    const std::vector<std::string> texts = vtkRelievoAnnotation::WriteValues(values);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      Label label = this->MakeLabel(texts[i]);
      label.At = values[i];
      label.Index = first + static_cast<long>(i);
      this->Axes[axis].Labels.push_back(label);
    }
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Segments);
  this->Lines->SetMapper(mapper);
  this->Lines->PickableOff();
  this->Lines->UseBoundsOff();
  this->Lines->ForceTranslucentOn();
  this->Lines->GetProperty()->LightingOff();
  this->DrawLines(this->DrawnSides, this->DrawnEdges);
}

//------------------------------------------------------------------------------
Grid::Label Grid::MakeLabel(const std::string& text) const
{
  Label label;
  label.Text = vtkSmartPointer<vtkTextActor>::New();
  label.Text->SetInput(text.c_str());
  label.Text->SetTextProperty(this->Font);
  label.Text->PickableOff();
  label.Text->VisibilityOff();
  return label;
}

//------------------------------------------------------------------------------
void Grid::Execute(vtkObject* caller, unsigned long, void*)
{
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(caller);
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (!window || GetShorterSide(renderer) <= 0)
  {
    return;
  }
  const int side = GetShorterSide(renderer);
  const int unmagnified = side / GetMagnification(window);
  const bool isPrinted = this->Print.Width > 0.0;
  this->Lines->GetProperty()->SetLineWidth(static_cast<float>(
    std::max(1.0, isPrinted ? this->Print.GetLineWidth() : std::round(side / FineLine))));
  const double pixels =
    isPrinted ? this->Print.GetTextSize() : std::max(SmallestText, unmagnified / LinesOfText);
  this->Font->SetFontSize(static_cast<int>(std::lround(pixels * 72.0 / window->GetDPI())));
  const Sides far = this->FindFarSides(renderer);
  const Edges numbered = this->PlaceLabels(renderer, far);
  if (far != this->DrawnSides || numbered != this->DrawnEdges)
  {
    this->DrawLines(far, numbered);
    this->DrawnSides = far;
    this->DrawnEdges = numbered;
  }
}

//------------------------------------------------------------------------------
// A side is far if the box's contents are in front of it.
Grid::Sides Grid::FindFarSides(vtkRenderer* renderer) const
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* eye = camera->GetPosition();
  const double* along = camera->GetDirectionOfProjection();
  Sides far{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (camera->GetParallelProjection())
    {
      far[axis] = { along[axis]<-1e-6, along[axis]> 1e-6 };
    }
    else
    {
      far[axis] = { eye[axis] > this->Ends[axis][0], eye[axis] < this->Ends[axis][1] };
    }
  }
  return far;
}

//------------------------------------------------------------------------------
// The edges along an axis are counted by the sides of the next axis (1) and the one after it (2).
std::array<double, 3> Grid::GetCorner(int axis, int edge) const
{
  std::array<double, 3> corner;
  for (int i = 0; i < 3; ++i)
  {
    const auto other = static_cast<std::size_t>((axis + i) % 3);
    const bool upper = i > 0 && (edge & i) != 0;
    corner[other] = this->Ends[other][upper ? 1 : 0];
  }
  return corner;
}

//------------------------------------------------------------------------------
void Grid::AddLine(
  const std::array<double, 3>& from, const std::array<double, 3>& to, unsigned char opacity)
{
  auto* colors = vtkUnsignedCharArray::SafeDownCast(this->Segments->GetPointData()->GetScalars());
  const unsigned char color[4] = { this->Ink[0], this->Ink[1], this->Ink[2], opacity };
  const vtkIdType ends[2] = { this->Segments->GetPoints()->InsertNextPoint(from.data()),
    this->Segments->GetPoints()->InsertNextPoint(to.data()) };
  colors->InsertNextTypedTuple(color);
  colors->InsertNextTypedTuple(color);
  this->Segments->GetLines()->InsertNextCell(2, ends);
}

//------------------------------------------------------------------------------
// A line through the box, along the axis.
void Grid::AddThrough(int axis, const std::array<double, 3>& from, bool edge)
{
  const auto along = static_cast<std::size_t>(axis);
  std::array<double, 3> ends[2] = { from, from };
  ends[0][along] = this->Ends[along][0];
  ends[1][along] = this->Ends[along][1];
  this->AddLine(ends[0], ends[1], edge ? Edge : Inner);
}

//------------------------------------------------------------------------------
// A tick in the plane of the far one of the two sides at the outer edge, beyond the other side.
void Grid::AddTicks(int axis, int edge, const Sides& far)
{
  const auto along = static_cast<std::size_t>(axis);
  const bool nextIsFar = far[(along + 1) % 3][edge & 1];
  const std::size_t across = (along + (nextIsFar ? 2 : 1)) % 3;
  const bool upper = (nextIsFar ? edge >> 1 : edge & 1) != 0;
  double longest = 0.0;
  for (const std::array<double, 2>& ends : this->Ends)
  {
    longest = std::max(longest, ends[1] - ends[0]);
  }
  for (const Label& label : this->Axes[along].Labels)
  {
    std::array<double, 3> from = this->GetCorner(axis, edge);
    from[along] = label.At;
    std::array<double, 3> to = from;
    to[across] += (upper ? Tick : -Tick) * longest;
    this->AddLine(from, to, Edge);
  }
}

//------------------------------------------------------------------------------
void Grid::DrawLines(const Sides& far, const Edges& numbered)
{
  this->Segments->SetPoints(vtkNew<vtkPoints>());
  this->Segments->SetLines(vtkNew<vtkCellArray>());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(4);
  this->Segments->GetPointData()->SetScalars(colors);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto next = static_cast<std::size_t>((axis + 1) % 3);
    const auto last = static_cast<std::size_t>((axis + 2) % 3);
    for (int edge = 0; edge < 4; ++edge)
    {
      if (far[next][edge & 1] || far[last][edge >> 1])
      {
        this->AddThrough(axis, this->GetCorner(axis, edge), true);
      }
    }
    if (const int edge = numbered[static_cast<std::size_t>(axis)]; edge >= 0)
    {
      this->AddTicks(axis, edge, far);
    }
    // Lines on the sides of the other two axes, at the numbers of the third.
    for (const auto& [on, at] : { std::make_pair(next, last), std::make_pair(last, next) })
    {
      for (std::size_t side = 0; side < 2; ++side)
      {
        for (const Label& label : this->Axes[at].Labels)
        {
          if (far[on][side])
          {
            std::array<double, 3> from{};
            from[on] = this->Ends[on][side];
            from[at] = label.At;
            this->AddThrough(axis, from, false);
          }
        }
      }
    }
  }
  this->Segments->Modified();
}

//------------------------------------------------------------------------------
// The text's box, with only its size set.
Grid::Box Grid::GetBox(vtkRenderer* renderer, const Label& label) const
{
  std::array<int, 4> extent{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(
    this->Font, label.Text->GetInput(), extent.data(), renderer->GetRenderWindow()->GetDPI());
  Box box;
  const int times = GetMagnification(renderer->GetRenderWindow());
  box.Size = { times * (extent[1] - extent[0] + 1.0), times * (extent[3] - extent[2] + 1.0) };
  return box;
}

//------------------------------------------------------------------------------
Grid::Edges Grid::PlaceLabels(vtkRenderer* renderer, const Sides& far)
{
  Edges numbered;
  std::vector<Box> taken;
  for (int i = 0; i < 3; ++i)
  {
    const int axis = (this->Up + i) % 3;
    Axis& placed = this->Axes[static_cast<std::size_t>(axis)];
    for (const Label& label : placed.Labels)
    {
      label.Text->VisibilityOff();
    }
    placed.Title.Text->VisibilityOff();
    numbered[static_cast<std::size_t>(axis)] = this->PlaceAxis(renderer, axis, far, taken);
  }
  return numbered;
}

//------------------------------------------------------------------------------
// Chooses the leftmost outer edge for the up axis, and the lowest one for the others.
int Grid::PlaceAxis(vtkRenderer* renderer, int axis, const Sides& far, std::vector<Box>& taken)
{
  const auto along = static_cast<std::size_t>(axis);
  const Axis& placed = this->Axes[along];
  const Projection project(renderer);
  using Pixel = std::array<double, 2>;
  std::optional<std::array<Pixel, 2>> best;
  int chosen = -1;
  std::array<double, 3> corner{};
  double least = 0.0;
  Pixel center{};
  int seen = 0;
  for (int edge = 0; edge < 4; ++edge)
  {
    std::array<double, 3> point = this->GetCorner(axis, edge);
    const auto from = project(point);
    point[along] = this->Ends[along][1];
    const auto to = project(point);
    if (!from || !to)
    {
      continue;
    }
    center = { center[0] + 0.5 * ((*from)[0] + (*to)[0]),
      center[1] + 0.5 * ((*from)[1] + (*to)[1]) };
    ++seen;
    const bool outer = far[(along + 1) % 3][edge & 1] != far[(along + 2) % 3][edge >> 1];
    const std::size_t across = axis == this->Up ? 0 : 1;
    const double cost = 0.5 * ((*from)[across] + (*to)[across]) / project.Size[across] +
      (project.IsInside(*from) ? 0.0 : 10.0) + (project.IsInside(*to) ? 0.0 : 10.0);
    if (outer && (!best || cost < least))
    {
      best = { *from, *to };
      chosen = edge;
      corner = point;
      least = cost;
    }
  }
  if (!best || placed.Labels.empty())
  {
    return -1;
  }
  const auto& [from, to] = *best;
  const Pixel middle = { 0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]) };
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  const double gap = std::max(4.0, 0.6 * this->GetBox(renderer, placed.Title).Size[1]);
  if (length < 5.0 * gap)
  {
    return -1; // the axis is seen end-on
  }
  Pixel out = { (from[1] - to[1]) / length, (to[0] - from[0]) / length };
  if ((middle[0] - center[0] / seen) * out[0] + (middle[1] - center[1] / seen) * out[1] < 0.0)
  {
    out = { -out[0], -out[1] };
  }
  double reach = 0.0;
  std::vector<Box> boxes;
  for (const Label& label : placed.Labels)
  {
    corner[along] = label.At;
    Box box = this->GetBox(renderer, label);
    box.Place(project(corner).value_or(middle), out, gap, project.Size);
    reach = std::max(reach, 2.0 * box.GetReach(out));
    boxes.push_back(box);
  }
  const auto show = [&taken](const Label& label, const Box& box) {
    label.Text->SetPosition(box.At[0], box.At[1]);
    label.Text->VisibilityOn();
    taken.push_back(box);
  };
  const auto isFree = [&taken](const Box& box) {
    return std::all_of(
      taken.begin(), taken.end(), [&box](const Box& other) { return box.IsApart(other); });
  };
  Box title = this->GetBox(renderer, placed.Title);
  title.Place(middle, out, 2.0 * gap + reach, project.Size);
  // Shows every number, or every second, fifth or tenth: round ones, without overlap.
  for (const long every : { 1L, 2L, 5L, 10L, 20L })
  {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      if (placed.Labels[i].Index % every == 0)
      {
        shown.push_back(i);
      }
    }
    const auto touches = [&](std::size_t one, std::size_t next) {
      return !boxes[one].IsApart(boxes[next]);
    };
    if (std::adjacent_find(shown.begin(), shown.end(), touches) != shown.end())
    {
      continue;
    }
    for (const std::size_t i : shown)
    {
      if (isFree(boxes[i]))
      {
        show(placed.Labels[i], boxes[i]);
      }
    }
    break;
  }
  if (isFree(title))
  {
    show(placed.Title, title);
  }
  return chosen;
}
}
