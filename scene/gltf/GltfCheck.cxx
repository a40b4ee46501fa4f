// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfCheck.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoModelReader.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace scene
{
namespace
{
constexpr double Near = 1e-4;   // of the scene's depths
constexpr double Levels = 4.;   // of 255: unlit textures are multiplied in another space
constexpr double Cosine = 0.99; // of the angle between normals: 8 degrees, where a mesh is coarse

// Hides the edges of surfaces, which files leave out, while it exists.
class HiddenEdges
{
public:
  explicit HiddenEdges(vtkRenderer* renderer)
  {
    vtkActorCollection* actors = renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
    {
      if (vtkProperty* property = actor->GetProperty(); property->GetEdgeVisibility())
      {
        property->EdgeVisibilityOff();
        this->Hidden.emplace_back(property);
      }
    }
  }
  ~HiddenEdges()
  {
    for (vtkProperty* property : this->Hidden)
    {
      property->EdgeVisibilityOn();
    }
  }
  HiddenEdges(const HiddenEdges&) = delete;
  HiddenEdges& operator=(const HiddenEdges&) = delete;

private:
  std::vector<vtkSmartPointer<vtkProperty>> Hidden;
};

vtkSmartPointer<vtkImageData> Draw(vtkRenderer* renderer)
{
  const HiddenEdges hidden(renderer);
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  for (const char* name : { "depth", "normal", "albedo", "actor" })
  {
    source->AddLayer(name);
  }
  source->Update();
  return source->GetOutput();
}

// The layers of a picture at one pixel.
struct Pixel
{
  double Depth = 0.;
  std::array<double, 3> Normal{};
  std::array<double, 4> Color{};
  int Actor = -1;
};

class Picture
{
public:
  explicit Picture(vtkImageData* image)
    : Columns(image->GetDimensions()[0])
    , Rows(image->GetDimensions()[1])
    , Depth(image->GetPointData()->GetArray("depth"))
    , Normal(image->GetPointData()->GetArray("normal"))
    , Color(image->GetPointData()->GetArray("albedo"))
    , Actor(image->GetPointData()->GetArray("actor"))
  {
  }

  bool IsComplete() const { return this->Depth && this->Normal && this->Color && this->Actor; }

  Pixel Get(int x, int y) const
  {
    const vtkIdType i = static_cast<vtkIdType>(y) * this->Columns + x;
    Pixel pixel;
    pixel.Depth = this->Depth->GetComponent(i, 0);
    this->Normal->GetTuple(i, pixel.Normal.data());
    this->Color->GetTuple(i, pixel.Color.data());
    pixel.Actor = static_cast<int>(this->Actor->GetComponent(i, 0));
    return pixel;
  }

  const int Columns, Rows;

private:
  vtkDataArray *Depth, *Normal, *Color, *Actor;
};

enum Layer
{
  InDepth,
  InNormal,
  InColor,
  Layers
};

// Whether the other picture's pixels around a pixel agree with it: in the range of their depths,
// and with one of their normals and colours.
std::array<bool, Layers> Compare(const Pixel& pixel, const Picture& found, int x, int y)
{
  std::array<bool, Layers> alike{};
  const bool isEmpty = pixel.Actor < 0;
  double low = std::numeric_limits<double>::max();
  double high = -low;
  for (int i = 0; i < 9; ++i)
  {
    const Pixel other = found.Get(x + i % 3 - 1, y + i / 3 - 1);
    if (isEmpty != (other.Actor < 0))
    {
      continue;
    }
    if (isEmpty)
    {
      return { true, true, true };
    }
    low = std::min(low, other.Depth);
    high = std::max(high, other.Depth);
    double cosine = 0.;
    bool isColored = true;
    for (std::size_t j = 0; j < 3; ++j)
    {
      cosine += pixel.Normal[j] * other.Normal[j];
      isColored = isColored && std::abs(pixel.Color[j] - other.Color[j]) <= Levels;
    }
    alike[InNormal] = alike[InNormal] || std::abs(cosine) >= Cosine;
    alike[InColor] = alike[InColor] || isColored;
  }
  const double tolerance = Near * std::abs(pixel.Depth);
  alike[InDepth] = low - tolerance <= pixel.Depth && pixel.Depth <= high + tolerance;
  return alike;
}

// The actors with some property, by their index in the renderer.
template <typename Test>
std::set<int> FindActors(vtkRenderer* renderer, Test&& has)
{
  std::set<int> found;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  for (int i = 0; vtkActor* actor = actors->GetNextActor(it); ++i)
  {
    if (has(actor))
    {
      found.insert(i);
    }
  }
  return found;
}

// Whether the file's reader makes other normals: of lines and points, and of normal maps, which a
// material of Relievo may draw.
bool HasOtherNormals(vtkActor* actor)
{
  auto* mesh = vtkPolyData::SafeDownCast(
    actor->GetMapper() ? actor->GetMapper()->GetInputDataObject(0, 0) : nullptr);
  return actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    actor->GetProperty()->GetTexture("normalTex") ||
    (mesh && mesh->GetNumberOfLines() + mesh->GetNumberOfVerts() > 0);
}

// Whether the actor has linear colours, and lines or points, which are unlit in the file.
bool HasOtherColors(vtkActor* actor)
{
  return HasOtherNormals(actor) && actor->GetProperty()->GetInterpolation() == VTK_PBR;
}

// Whether one of the actors is next to a pixel.
bool IsNear(const std::set<int>& actors, const Picture& picture, int x, int y)
{
  for (int i = 0; !actors.empty() && i < 9; ++i)
  {
    if (actors.count(picture.Get(x + i % 3 - 1, y + i / 3 - 1).Actor) != 0)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
std::string FindDifference(vtkRenderer* renderer, const std::string& file, const glm::dmat4& toFile,
  const std::vector<vtkActor*>& actors, const std::set<vtkActor*>& partial)
{
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkMultiBlockDataSet* blocks = reader->GetOutput();
  if (!blocks || blocks->GetNumberOfBlocks() == 0)
  {
    return "cannot be read again";
  }
  vtkNew<vtkRenderer> other;
  vtkNew<vtkMatrix4x4> back;
  const glm::dmat4 toScene = glm::inverse(toFile);
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      back->SetElement(row, column, toScene[column][row]);
    }
  }
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(vtkPolyData::SafeDownCast(blocks->GetBlock(i)));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    reader->ApplyMaterial(static_cast<int>(i), actor);
    actor->SetUserMatrix(back);
    // glTF has no sizes of points and no widths of lines.
    if (actors.size() == blocks->GetNumberOfBlocks())
    {
      vtkProperty* own = actors[i]->GetProperty();
      actor->GetProperty()->SetPointSize(own->GetPointSize());
      actor->GetProperty()->SetLineWidth(own->GetLineWidth());
      actor->GetProperty()->SetRenderPointsAsSpheres(own->GetRenderPointsAsSpheres());
      actor->GetProperty()->SetRenderLinesAsTubes(own->GetRenderLinesAsTubes());
    }
    other->AddActor(actor);
  }
  // A window inside another program's, such as Qt's, has no context of its own.
  vtkRenderWindow* shown = renderer->GetRenderWindow();
  const auto window = shown->IsA("vtkGenericOpenGLRenderWindow")
    ? vtkSmartPointer<vtkRenderWindow>::New()
    : vtkSmartPointer<vtkRenderWindow>::Take(shown->NewInstance());
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  const int* size = renderer->GetSize();
  window->SetSize(size[0], size[1]);
  window->AddRenderer(other);
  other->GetActiveCamera()->DeepCopy(renderer->GetActiveCamera());
  const vtkSmartPointer<vtkImageData> images[] = { Draw(renderer), Draw(other) };
  window->RemoveRenderer(other);
  shown->MakeCurrent();
  const Picture expected(images[0]);
  const Picture found(images[1]);
  if (!expected.IsComplete() || !found.IsComplete() || expected.Columns != found.Columns ||
    expected.Rows != found.Rows)
  {
    return "cannot be drawn for comparison";
  }
  const std::set<int> bare = FindActors(renderer, HasOtherNormals);
  const std::set<int> coded = FindActors(renderer, HasOtherColors);
  const std::set<int> left =
    FindActors(renderer, [&partial](vtkActor* actor) { return partial.count(actor) != 0; });
  std::array<vtkIdType, Layers> different{};
  for (int y = 1; y + 1 < expected.Rows; ++y)
  {
    for (int x = 1; x + 1 < expected.Columns; ++x)
    {
      // An edge may lie on the other side of a pixel's centre: a neighbour must then agree.
      const Pixel pixel = expected.Get(x, y);
      std::array<bool, Layers> alike = Compare(pixel, found, x, y);
      if (IsNear(left, expected, x, y))
      {
        continue;
      }
      alike[InNormal] = alike[InNormal] || bare.count(pixel.Actor) != 0;
      alike[InColor] = alike[InColor] || coded.count(pixel.Actor) != 0;
      for (std::size_t layer = 0; layer < Layers; ++layer)
      {
        different[layer] += alike[layer] ? 0 : 1;
      }
    }
  }
  const char* const names[] = { "depth", "normals", "colours" };
  std::string words;
  for (std::size_t layer = 0; layer < Layers; ++layer)
  {
    if (different[layer] > 0)
    {
      words += (words.empty() ? "differs from the scene in " : ", ") + std::string(names[layer]) +
        " of " + std::to_string(different[layer]) + " pixels";
    }
  }
  return words;
}
}
