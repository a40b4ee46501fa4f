// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoHiddenPoints.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoCutSurface.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoPointGroups.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
using Access = vtkRelievoAccess::Mapper;

// With fewer points, the search takes as long as the drawing.
constexpr vtkIdType FewestPoints = 10000;
constexpr double MostPixels = 32.0; // per point
constexpr double LargestLoss = 20.0;
constexpr float LargestSize = 32.0f; // pixels: the tables' size grows with its square
constexpr float Infinity = std::numeric_limits<float>::infinity();

// VTK's drawing of a point as a sphere: in the pixels around it, GetScale(z) times a share is added
// to the point's window z. The share depends only on the pixel's position (vtkPolyDataFS.glsl).
struct Spheres
{
  double Radius = 0.5; // pixels
  bool Parallel = false;
  double S = 0.0; // VTK's ZCalcS
  double R = 0.0; // VTK's ZCalcR

  double GetScale(double z) const { return this->Parallel ? this->S * this->R : z - this->S; }
  // At a distance from the centre, squared, in pixels.
  double GetShare(double distance2) const
  {
    const double height =
      std::sqrt(std::min(std::max(0.0, 1.0 - distance2 / (this->Radius * this->Radius)), 1.0));
    const double near = height * this->R;
    return this->Parallel ? height : near / (1.0 - near);
  }
};

// Shares for points anywhere within their pixel: lower bounds for the pixels that are certainly
// drawn, and upper bounds for those that may be. -infinity at pixels that are not drawn.
class Shares
{
public:
  static constexpr int Phases = 16; // positions within the pixel, in each direction
  static constexpr int Lane = 8;    // columns are padded to a multiple of this

  Shares(const Spheres& spheres, double slack)
    : Loose(slack + std::sqrt(0.5) / Phases)
    , Reach(static_cast<int>(std::ceil(spheres.Radius + this->Loose + 0.5)))
    , Rows(2 * this->Reach)
    , Columns((2 * this->Reach + Lane - 1) / Lane * Lane)
  {
    for (int v = 0; v < Phases; ++v)
    {
      for (int u = 0; u < Phases; ++u)
      {
        for (int row = 0; row < this->Rows; ++row)
        {
          for (int column = 0; column < this->Columns; ++column)
          {
            const double distance = std::hypot(column - this->Reach + 0.5 - (u + 0.5) / Phases,
              row - this->Reach + 0.5 - (v + 0.5) / Phases);
            const double least = distance + this->Loose;
            const double most = std::max(0.0, distance - this->Loose);
            this->Least.push_back(least < spheres.Radius
                ? static_cast<float>(spheres.GetShare(least * least))
                : -Infinity);
            this->Most.push_back(most < spheres.Radius
                ? static_cast<float>(spheres.GetShare(most * most))
                : -Infinity);
          }
        }
      }
    }
    this->Largest = static_cast<float>(spheres.GetShare(0.0));
  }

  // The table for a point at this position within its pixel.
  const float* Get(const std::vector<float>& of, double u, double v) const
  {
    const int phase = static_cast<int>(v * Phases) * Phases + static_cast<int>(u * Phases);
    return of.data() + static_cast<std::size_t>(phase) * this->Rows * this->Columns;
  }

  const double Loose; // uncertainty of positions, in pixels
  // Pixels from the point's own to the left and down; one less to the right and up.
  const int Reach;
  const int Rows;
  const int Columns;
  std::vector<float> Least;
  std::vector<float> Most;
  float Largest; // over all entries
};

// A point in the window: its pixel, its position within it, and its z.
struct Place
{
  int X;
  int Y;
  double U;
  double V;
  double Z;
  unsigned int Vertex;
};

// Pixels that points may draw to, by their first and last block of pixels in each direction, and
// the least z that they may have there.
struct Cover
{
  int Left = 0;
  int Right = 0;
  int Bottom = 0;
  int Top = 0;
  float Z = -Infinity; // may be seen anywhere
};

// Neighbouring points.
struct Group
{
  std::size_t First; // in the mesh's order
  std::size_t End;
  glm::dvec3 Low; // corner of the points' box
  Cover Pixels;
  bool Vague; // OpenGL's positions are not known well enough
};

// Loss of precision in a group's positions, as a factor; 1 if the view is not much smaller than the
// distance to the origin of the stored floats. Infinite for groups beside and behind the camera.
double GetLoss(
  const glm::dmat4& toNDC, const glm::dvec3& origin, const vtkRelievoPointGroups::Group& group)
{
  const glm::dvec4 moved = toNDC * glm::dvec4(origin, 1.0);
  double loss = 1.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 point((corner & 1) != 0 ? group.High.x : group.Low.x,
      (corner & 2) != 0 ? group.High.y : group.Low.y,
      (corner & 4) != 0 ? group.High.z : group.Low.z);
    const glm::dvec3 stored = glm::abs(point - origin);
    const double w = (toNDC * glm::dvec4(point, 1.0)).w;
    for (int row = 0; row < 4; ++row)
    {
      const double sum = std::abs(moved[row]) + std::abs(toNDC[0][row]) * stored.x +
        std::abs(toNDC[1][row]) * stored.y + std::abs(toNDC[2][row]) * stored.z;
      // The bounds for a loss of 1 allow for a sum of four times w.
      loss = w > 0.0 ? std::max(loss, 0.25 * sum / w) : std::numeric_limits<double>::infinity();
    }
  }
  return loss;
}

class Finder
{
public:
  Finder(const glm::dmat4& toNDC, const int viewport[4], const Spheres& spheres, double slack,
    double tolerance)
    : ToNDC(toNDC)
    , Size(viewport[2], viewport[3])
    , Drawn(spheres)
    , Tolerance(tolerance)
    , Table(spheres, slack)
    , Border(this->Table.Reach + this->Table.Columns)
    , Across((this->Size.x + 2 * this->Border) / Block + 1)
    , Up((this->Size.y + 2 * this->Border) / Block + 1)
    , Stride(this->Across * Block)
    , Nearest(static_cast<std::size_t>(this->Stride) * this->Up * Block, Farthest)
    , Farthests(static_cast<std::size_t>(this->Across) * this->Up, Farthest)
    , Changed(this->Farthests.size(), 0)
  {
  }

  // The points that may be seen, in the order of the vertices; groups with losses above the largest
  // are seen.
  std::vector<unsigned int> Find(
    const vtkRelievoPointGroups::Mesh& mesh, const std::vector<double>& losses)
  {
    std::vector<bool> seen(mesh.GetNumberOfVertices());
    std::vector<Place> places;
    // From the front to the back: groups behind others need no look at their points.
    std::vector<Group> groups = this->GetGroups(mesh, losses);
    for (Group& group : groups)
    {
      const bool hidden = this->IsHidden(group.Pixels);
      const std::size_t first = places.size();
      for (std::size_t i = group.First; i < group.End && !hidden; ++i)
      {
        Place place;
        place.Vertex = mesh.Order[i];
        const Where where =
          group.Vague ? UNKNOWN : this->Project(group.Low + glm::dvec3(mesh.Places[i]), place);
        if (where == UNKNOWN)
        {
          seen[place.Vertex] = true;
        }
        else if (where == INSIDE && this->MayBeSeen(place))
        {
          this->Put(place);
          places.push_back(place);
        }
      }
      group.First = first; // in places, from here on
      group.End = places.size();
    }
    for (const Group& group : groups)
    {
      const bool hidden = this->IsHidden(group.Pixels);
      for (std::size_t i = group.First; i < group.End && !hidden; ++i)
      {
        seen[places[i].Vertex] = this->MayBeSeen(places[i]);
      }
    }
    std::vector<unsigned int> numbers;
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
      if (seen[i])
      {
        numbers.push_back(mesh.GetPoint(static_cast<unsigned int>(i)));
      }
    }
    return numbers;
  }

private:
  static constexpr float Farthest = 2.0f; // z of the background
  static constexpr int Block = 8;         // pixels
  enum Where
  {
    INSIDE,
    OUTSIDE,
    UNKNOWN
  };

  Where Project(const glm::dvec3& point, Place& place) const
  {
    const glm::dmat4& m = this->ToNDC;
    const double w = m[0][3] * point[0] + m[1][3] * point[1] + m[2][3] * point[2] + m[3][3];
    const double over = 0.5 / w;
    const double x =
      (m[0][0] * point[0] + m[1][0] * point[1] + m[2][0] * point[2] + m[3][0]) * over + 0.5;
    const double y =
      (m[0][1] * point[0] + m[1][1] * point[1] + m[2][1] * point[2] + m[3][1]) * over + 0.5;
    place.Z = (m[0][2] * point[0] + m[1][2] * point[1] + m[2][2] * point[2] + m[3][2]) * over + 0.5;
    const double column = x * this->Size.x;
    const double row = y * this->Size.y;
    if (!(w > 0.0 && place.Z > 0.0 && place.Z < 1.0 && column > 0.0 && row > 0.0 &&
          column < this->Size.x && row < this->Size.y))
    {
      // OpenGL may clip points at the window's borders.
      const double size = 2.0 * this->Drawn.Radius;
      return w > 0.0 &&
          (column < -size || row < -size || column > this->Size.x + size ||
            row > this->Size.y + size)
        ? OUTSIDE
        : UNKNOWN;
    }
    place.X = static_cast<int>(column);
    place.Y = static_cast<int>(row);
    place.U = column - place.X;
    place.V = row - place.Y;
    return INSIDE;
  }

  // The groups, the nearest first.
  std::vector<Group> GetGroups(
    const vtkRelievoPointGroups::Mesh& mesh, const std::vector<double>& losses) const
  {
    std::vector<Group> groups;
    groups.reserve(mesh.Groups.size());
    std::size_t first = 0;
    for (const vtkRelievoPointGroups::Group& group : mesh.Groups)
    {
      const bool vague = losses[groups.size()] > LargestLoss;
      groups.push_back(
        { first, group.End, group.Low, vague ? Cover() : this->GetCover(group), vague });
      first = group.End;
    }
    std::sort(groups.begin(), groups.end(),
      [](const Group& a, const Group& b) { return a.Pixels.Z < b.Pixels.Z; });
    return groups;
  }

  // The pixels that a group covers, by the corners of its box, if all are inside.
  Cover GetCover(const vtkRelievoPointGroups::Group& group) const
  {
    Place least{ this->Size.x, this->Size.y, 0.0, 0.0, 1.0, 0 };
    Place most{ 0, 0, 0.0, 0.0, 0.0, 0 };
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 point((corner & 1) != 0 ? group.High.x : group.Low.x,
        (corner & 2) != 0 ? group.High.y : group.Low.y,
        (corner & 4) != 0 ? group.High.z : group.Low.z);
      Place place;
      if (this->Project(point, place) != INSIDE)
      {
        return {};
      }
      least.X = std::min(least.X, place.X);
      least.Y = std::min(least.Y, place.Y);
      least.Z = std::min(least.Z, place.Z);
      most.X = std::max(most.X, place.X);
      most.Y = std::max(most.Y, place.Y);
    }
    return this->GetCover(least, most, 2.0 * this->Tolerance);
  }

  Cover GetCover(const Place& least, const Place& most, double tolerance) const
  {
    const int down = this->Border - this->Table.Reach;
    const int up = this->Border + this->Table.Reach - 1;
    return { (least.X + down) / Block, (most.X + up) / Block, (least.Y + down) / Block,
      (most.Y + up) / Block,
      static_cast<float>(least.Z - tolerance) +
        static_cast<float>(this->Drawn.GetScale(least.Z)) * this->Table.Largest };
  }

  // Whether something nearer covers all pixels.
  bool IsHidden(const Cover& pixels)
  {
    for (int y = pixels.Bottom; y <= pixels.Top; ++y)
    {
      for (int x = pixels.Left; x <= pixels.Right; ++x)
      {
        if (pixels.Z <= this->GetFarthest(x, y, pixels.Z))
        {
          return false;
        }
      }
    }
    return true;
  }

  // The farthest of the nearest z in a block; or only an upper bound, if that is less than z.
  float GetFarthest(int x, int y, float z)
  {
    const std::size_t block = static_cast<std::size_t>(y) * this->Across + x;
    if (this->Changed[block] != 0 && this->Farthests[block] >= z)
    {
      this->Changed[block] = 0;
      float farthest[Block] = {};
      const float* nearest =
        this->Nearest.data() + static_cast<std::size_t>(y) * Block * this->Stride + x * Block;
      for (int row = 0; row < Block; ++row)
      {
        for (int column = 0; column < Block; ++column)
        {
          farthest[column] = std::max(farthest[column], nearest[column]);
        }
        nearest += this->Stride;
      }
      this->Farthests[block] = *std::max_element(farthest, farthest + Block);
    }
    return this->Farthests[block];
  }

  std::size_t GetFirst(const Place& place) const
  {
    return static_cast<std::size_t>(place.Y + this->Border - this->Table.Reach) * this->Stride +
      place.X + this->Border - this->Table.Reach;
  }

  void Put(const Place& place)
  {
    const float* share = this->Table.Get(this->Table.Least, place.U, place.V);
    const auto z = static_cast<float>(place.Z);
    const auto scale = static_cast<float>(this->Drawn.GetScale(place.Z));
    float* nearest = this->Nearest.data() + this->GetFirst(place);
    for (int row = 0; row < this->Table.Rows; ++row)
    {
      for (int column = 0; column < this->Table.Columns; column += Shares::Lane)
      {
        PutLane(nearest + column, share + column, z, scale);
      }
      nearest += this->Stride;
      share += this->Table.Columns;
    }
    const Cover pixels = this->GetCover(place, place, 0.0);
    for (int y = pixels.Bottom; y <= pixels.Top; ++y)
    {
      for (int x = pixels.Left; x <= pixels.Right; ++x)
      {
        this->Changed[static_cast<std::size_t>(y) * this->Across + x] = 1;
      }
    }
  }

  bool MayBeSeen(const Place& place)
  {
    if (this->IsHidden(this->GetCover(place, place, this->Tolerance)))
    {
      return false;
    }
    const float* share = this->Table.Get(this->Table.Most, place.U, place.V);
    const auto z = static_cast<float>(place.Z - this->Tolerance);
    const auto scale = static_cast<float>(this->Drawn.GetScale(place.Z));
    const float* nearest = this->Nearest.data() + this->GetFirst(place);
    for (int row = 0; row < this->Table.Rows; ++row)
    {
      for (int column = 0; column < this->Table.Columns; column += Shares::Lane)
      {
        if (IsLaneSeen(nearest + column, share + column, z, scale))
        {
          return true;
        }
      }
      nearest += this->Stride;
      share += this->Table.Columns;
    }
    return false;
  }

  // Without branches, so that the compiler can vectorize. OpenGL clamps z in front of the near
  // plane.
  static void PutLane(float* nearest, const float* share, float z, float scale)
  {
    float made[Shares::Lane];
    for (int i = 0; i < Shares::Lane; ++i)
    {
      made[i] = std::max(z + scale * share[i], 0.0f);
    }
    for (int i = 0; i < Shares::Lane; ++i)
    {
      nearest[i] = made[i] < nearest[i] ? made[i] : nearest[i];
    }
  }
  static bool IsLaneSeen(const float* nearest, const float* share, float z, float scale)
  {
    float behind[Shares::Lane];
    for (int i = 0; i < Shares::Lane; ++i)
    {
      behind[i] = z + scale * share[i] - nearest[i];
    }
    for (int half = Shares::Lane / 2; half > 0; half /= 2)
    {
      for (int i = 0; i < half; ++i)
      {
        behind[i] = behind[i + half] < behind[i] ? behind[i + half] : behind[i];
      }
    }
    return behind[0] <= 0.0f;
  }

  const glm::dmat4 ToNDC;
  const glm::ivec2 Size;
  const Spheres Drawn;
  const double Tolerance; // of z
  const Shares Table;
  const int Border;
  const int Across; // blocks of pixels
  const int Up;
  const int Stride;
  std::vector<float> Nearest;   // z per pixel, with a border around the window
  std::vector<float> Farthests; // of the nearest z per block
  std::vector<char> Changed;    // per block, after its farthest z was found
};

// The mapper, if it draws from existing buffers, by numbers of points alone.
vtkOpenGLPolyDataMapper* GetMapperOfSpheres(vtkProp* prop)
{
  vtkPolyData* mesh = vtkRelievoHiddenPoints::GetMesh(prop);
  if (!mesh)
  {
    return nullptr;
  }
  auto* actor = static_cast<vtkActor*>(prop);
  auto* mapper = static_cast<vtkOpenGLPolyDataMapper*>(actor->GetMapper());
  const bool current = mapper->CurrentInput == mesh &&
    Access::BuildTime(mapper) >= mesh->GetMTime() &&
    Access::BuildTime(mapper) >= mapper->GetMTime() && Access::AreBuffersOf(mapper, actor);
  // VTK looks colours of cells up by the number of the drawn primitive.
  return current && !Access::HasCellColors(mapper) ? mapper : nullptr;
}

// The origin of the positions that the buffer stores as floats.
glm::dvec3 GetOrigin(vtkOpenGLPolyDataMapper* mapper)
{
  vtkOpenGLVertexBufferObject* vertices = Access::Buffers(mapper)->GetVBO("vertexMC");
  if (!vertices || !vertices->GetCoordShiftAndScaleEnabled())
  {
    return glm::dvec3(0.0);
  }
  const std::vector<double>& shift = vertices->GetShift();
  return { shift[0], shift[1], shift[2] };
}
}

//------------------------------------------------------------------------------
bool vtkRelievoHiddenPoints::IsPossible(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* any = actor ? actor->GetMapper() : nullptr;
  if (!any || !actor->GetProperty()->GetRenderPointsAsSpheres() ||
    actor->GetProperty()->GetPointSize() > LargestSize ||
    std::strcmp(any->GetClassName(), "vtkOpenGLPolyDataMapper") != 0)
  {
    return false;
  }
  vtkPolyData* mesh = static_cast<vtkOpenGLPolyDataMapper*>(any)->GetInput();
  return mesh && mesh->GetPoints() &&
    mesh->GetVerts()->GetNumberOfConnectivityIds() >= FewestPoints &&
    vtkRelievoPlainActor::IsOfClass(actor);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkRelievoHiddenPoints::GetMesh(vtkProp* prop)
{
  if (!IsPossible(prop))
  {
    return nullptr;
  }
  auto* actor = static_cast<vtkActor*>(prop);
  auto* mapper = static_cast<vtkOpenGLPolyDataMapper*>(actor->GetMapper());
  vtkProperty* property = actor->GetProperty();
  mapper->GetBounds(); // updates the mapper's input
  vtkPolyData* mesh = mapper->GetInput();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const bool others = mesh->GetNumberOfVerts() != mesh->GetNumberOfCells() ||
    mapper->GetNumberOfSubPieces() > 1 || property->GetRepresentation() != VTK_SURFACE ||
    property->GetVertexVisibility() || actor->GetTexture() || property->GetNumberOfTextures() > 0 ||
    vtkRelievoPlainActor::HasOwnShaders(actor) ||
    vtkRelievoCutSurface::GetCutoff(actor->GetPropertyKeys()) > 0.0 ||
    vtkMapper::GetResolveCoincidentTopology() != VTK_RESOLVE_OFF ||
    (planes && planes->GetNumberOfItems() > 0) || actor->HasTranslucentPolygonalGeometry();
  return others ? nullptr : mesh;
}

//------------------------------------------------------------------------------
vtkRelievoHiddenPoints::vtkRelievoHiddenPoints(
  vtkProp* prop, vtkRenderer* renderer, vtkRelievoPointGroups& groups)
{
  vtkOpenGLPolyDataMapper* mapper = GetMapperOfSpheres(prop);
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!mapper || !camera || !window || !vtkRelievoIsSoftwareOpenGL())
  {
    return;
  }
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkPolyData* mesh = mapper->GetInput();
  if (static_cast<double>(viewport[2]) * viewport[3] >
    MostPixels * static_cast<double>(mesh->GetVerts()->GetNumberOfConnectivityIds()))
  {
    return;
  }
  vtkMatrix4x4* worldToView = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkMatrix4x4* viewToNDC = nullptr;
  vtkMatrix4x4* worldToNDC = nullptr;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToNDC, worldToNDC);
  auto* actor = static_cast<vtkActor*>(prop);
  // VTK stores matrices transposed.
  const glm::dmat4 toNDC =
    glm::transpose(vtkRelievoToGlm(worldToNDC)) * vtkRelievoToGlm(actor->GetMatrix());
  Spheres spheres;
  const double size = actor->GetProperty()->GetPointSize();
  spheres.Radius = 0.5 * size;
  spheres.Parallel = camera->GetParallelProjection() != 0;
  const double depth = viewToNDC->GetElement(2, 2);
  spheres.S = spheres.Parallel ? depth : 0.5 - 0.5 * depth;
  spheres.R = size / (renderer->GetSize()[0] * viewToNDC->GetElement(0, 0));
  const bool usual = spheres.Parallel ? spheres.S < 0.0 : spheres.S > 1.0;
  if (!(usual && spheres.R > 0.0 && spheres.R < 0.5))
  {
    return;
  }
  const vtkRelievoPointGroups::Mesh& points = groups.Get(mesh);
  std::vector<double> losses;
  double loss = 1.0;
  for (const vtkRelievoPointGroups::Group& group : points.Groups)
  {
    losses.push_back(GetLoss(toNDC, GetOrigin(mapper), group));
    loss = losses.back() > LargestLoss ? loss : std::max(loss, losses.back());
  }
  // OpenGL places points on a grid of 1/256 pixel.
  const double slack = 0.01 + 1e-6 * loss * std::max(viewport[2], viewport[3]);
  const double tolerance = 1e-6 * loss * std::max(1.0, std::abs(spheres.S));
  Finder finder(toNDC, viewport, spheres, slack, tolerance);
  const std::vector<unsigned int> seen = finder.Find(points, losses);
  if (!seen.empty() && this->Seen->Upload(seen, vtkOpenGLBufferObject::ElementArrayBuffer))
  {
    this->Seen->IndexCount = seen.size();
    this->Mapper = mapper;
    vtkOpenGLIndexBufferObject*& used =
      Access::IndicesInUse(mapper, vtkOpenGLPolyDataMapper::PrimitivePoints);
    this->All = used;
    used = this->Seen;
  }
}

//------------------------------------------------------------------------------
vtkRelievoHiddenPoints::~vtkRelievoHiddenPoints()
{
  if (this->Mapper)
  {
    Access::IndicesInUse(this->Mapper, vtkOpenGLPolyDataMapper::PrimitivePoints) = this->All;
    this->Seen->ReleaseGraphicsResources();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoHiddenPoints::GetNumberOfSeen() const
{
  return this->Mapper ? static_cast<vtkIdType>(this->Seen->IndexCount) : -1;
}
