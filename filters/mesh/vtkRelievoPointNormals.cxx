// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPointNormals.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRelievoPointNormals);

namespace
{
constexpr vtkIdType ChunkSize = 65536;  // points
constexpr std::size_t ManyCorners = 48; // above this, searching pays

using FloatVector = std::array<float, 3>;

// The polygons as arrays.
template <typename Id>
struct Polygons
{
  const Id* Starts;
  const Id* Corners;
  vtkIdType Count;

  vtkIdType GetStart(vtkIdType polygon) const { return static_cast<vtkIdType>(Starts[polygon]); }
};

//------------------------------------------------------------------------------
// The polygons around each point, in order, once for each of their corners there.
class Links
{
public:
  Links() = default;
  template <typename Id>
  Links(const Polygons<Id>& polygons, vtkIdType numberOfPoints)
    : Ends(static_cast<std::size_t>(numberOfPoints) + 1, 0)
  {
    const vtkIdType corners = polygons.GetStart(polygons.Count);
    this->Of.resize(static_cast<std::size_t>(corners));
    // Counts become ends, which become beginnings as polygons are filled in from the last one.
    for (vtkIdType corner = polygons.GetStart(0); corner < corners; ++corner)
    {
      ++this->Ends[static_cast<std::size_t>(polygons.Corners[corner])];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& end : this->Ends)
    {
      sum += end;
      end = sum;
    }
    for (vtkIdType polygon = polygons.Count; polygon-- > 0;)
    {
      for (vtkIdType corner = polygons.GetStart(polygon + 1);
           corner-- > polygons.GetStart(polygon);)
      {
        const auto point = static_cast<std::size_t>(polygons.Corners[corner]);
        this->Of[--this->Ends[point]] = static_cast<std::uint32_t>(polygon);
      }
    }
  }

  const std::uint32_t* Begin(vtkIdType point) const
  {
    return this->Of.data() + this->Ends[static_cast<std::size_t>(point)];
  }
  const std::uint32_t* End(vtkIdType point) const { return this->Begin(point + 1); }

private:
  std::vector<std::uint32_t> Ends;
  std::vector<std::uint32_t> Of;
};

//------------------------------------------------------------------------------
// The additional points that a range needs.
struct Splits
{
  struct Copy
  {
    vtkIdType Of; // point
    FloatVector Normal;
  };
  struct Move // of a corner
  {
    vtkIdType Corner;
    std::size_t To; // index of the copy
  };
  std::vector<Copy> Copies;
  std::vector<Move> Moves;
};

// Rounded at each step as in vtkPolyDataNormals.
FloatVector GetUnit(const FloatVector& sum)
{
  const float length = vtkMath::Norm(sum.data());
  const auto factor = static_cast<float>(1. / static_cast<double>(length));
  return length != 0.f ? FloatVector{ factor * sum[0], factor * sum[1], factor * sum[2] } : sum;
}

//------------------------------------------------------------------------------
// Groups the polygons around one point.
template <typename Id>
class Grouping
{
public:
  Grouping(const Polygons<Id>& polygons, const float* normals, double leastCosine)
    : All(polygons)
    , Normals(normals)
    , LeastCosine(leastCosine)
  {
  }

  // Returns the point's own normal; `splits` gets those of its other groups.
  FloatVector Do(
    vtkIdType point, const std::uint32_t* begin, const std::uint32_t* end, Splits& splits)
  {
    if (this->Group(point, begin, end) > 1)
    {
      this->Split(point, splits);
    }
    FloatVector sum = {};
    for (const Part& part : this->Parts)
    {
      for (int i = 0; part.Group == 0 && i < part.Times; ++i)
      {
        this->AddNormal(part.Polygon, sum);
      }
    }
    return GetUnit(sum);
  }

private:
  struct Part // a polygon at the point
  {
    vtkIdType Polygon;
    Id Beside[2]; // the points of the corners before and after the point's first one
    int Times;    // corners at the point
    int Group;
  };
  // A point adjacent to the current one, and the part that has it. There are few, except at the tip
  // of a cone.
  using Corner = std::pair<Id, std::uint32_t>;

  void AddNormal(vtkIdType polygon, FloatVector& sum) const
  {
    const float* normal = this->Normals + 3 * polygon;
    sum = { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] };
  }

  void List(vtkIdType point, const std::uint32_t* begin, const std::uint32_t* end)
  {
    this->Parts.clear();
    this->Corners.clear();
    for (const std::uint32_t* each = begin; each != end; ++each)
    {
      if (each != begin && *each == each[-1])
      {
        ++this->Parts.back().Times;
        continue;
      }
      const auto polygon = static_cast<vtkIdType>(*each);
      const Id* const ids = this->All.Corners + this->All.GetStart(polygon);
      const vtkIdType last = this->All.GetStart(polygon + 1) - this->All.GetStart(polygon) - 1;
      const auto number = static_cast<std::uint32_t>(this->Parts.size());
      vtkIdType spot = -1;
      for (vtkIdType i = 0; i <= last; ++i)
      {
        if (static_cast<vtkIdType>(ids[i]) != point)
        {
          this->Corners.emplace_back(ids[i], number);
        }
        else if (spot < 0)
        {
          spot = i;
        }
      }
      const Id before = ids[spot == 0 ? last : spot - 1];
      const Id behind = ids[spot == last ? 0 : spot + 1];
      const bool turned = spot == last && spot != 0;
      this->Parts.push_back(
        { polygon, { turned ? before : behind, turned ? behind : before }, 1, -1 });
    }
    this->Sorted = this->Corners.size() > ManyCorners;
    if (this->Sorted)
    {
      std::sort(this->Corners.begin(), this->Corners.end());
    }
  }

  // The only other part with the adjacent point `beside`; nullptr if there is none, or several.
  Part* FindNeighbor(const Part* of, Id beside)
  {
    auto corner = this->Corners.begin();
    auto end = this->Corners.end();
    if (this->Sorted)
    {
      corner = std::lower_bound(corner, end, Corner(beside, 0));
      end =
        std::upper_bound(corner, end, Corner(beside, std::numeric_limits<std::uint32_t>::max()));
    }
    Part* found = nullptr;
    for (; corner != end; ++corner)
    {
      Part* const part = &this->Parts[corner->second];
      if (corner->first == beside && part != of && part != found)
      {
        if (found)
        {
          return nullptr;
        }
        found = part;
      }
    }
    return found;
  }

  bool IsSmooth(const Part* a, const Part* b) const
  {
    return static_cast<double>(vtkMath::Dot(
             this->Normals + 3 * a->Polygon, this->Normals + 3 * b->Polygon)) > this->LeastCosine;
  }

  // Returns the number of groups.
  int Group(vtkIdType point, const std::uint32_t* begin, const std::uint32_t* end)
  {
    this->List(point, begin, end);
    int groups = 0;
    for (Part& first : this->Parts)
    {
      if (first.Group >= 0)
      {
        continue;
      }
      first.Group = groups;
      for (const Id start : first.Beside)
      {
        Id beside = start;
        const Part* part = &first;
        while (Part* const next = this->FindNeighbor(part, beside))
        {
          if (next->Group >= 0 || !this->IsSmooth(part, next))
          {
            break;
          }
          next->Group = groups;
          beside = next->Beside[next->Beside[0] != beside ? 0 : 1];
          part = next;
        }
      }
      ++groups;
    }
    return groups;
  }

  void Split(vtkIdType point, Splits& splits) const
  {
    const std::size_t before = splits.Copies.size();
    for (const Part& part : this->Parts)
    {
      if (part.Group == 0)
      {
        continue;
      }
      const std::size_t copy = before + static_cast<std::size_t>(part.Group) - 1;
      if (copy == splits.Copies.size())
      {
        splits.Copies.push_back({ point, {} });
      }
      for (int i = 0; i < part.Times; ++i)
      {
        this->AddNormal(part.Polygon, splits.Copies[copy].Normal);
      }
      const vtkIdType end = this->All.GetStart(part.Polygon + 1);
      for (vtkIdType corner = this->All.GetStart(part.Polygon); corner < end; ++corner)
      {
        if (static_cast<vtkIdType>(this->All.Corners[corner]) == point)
        {
          splits.Moves.push_back({ corner, copy });
        }
      }
    }
    for (std::size_t copy = before; copy < splits.Copies.size(); ++copy)
    {
      splits.Copies[copy].Normal = GetUnit(splits.Copies[copy].Normal);
    }
  }

  const Polygons<Id>& All;
  const float* const Normals;
  const double LeastCosine;
  std::vector<Part> Parts;
  std::vector<Corner> Corners;
  bool Sorted = false;
};

//------------------------------------------------------------------------------
template <typename Real, typename Id>
std::vector<float> MakePolygonNormals(
  const Real* places, vtkPoints* points, const Polygons<Id>& polygons)
{
  std::vector<float> normals(3 * static_cast<std::size_t>(polygons.Count));
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPTools::For(0, polygons.Count, [&](vtkIdType begin, vtkIdType end) {
    vtkIdList* const list = lists.Local();
    for (vtkIdType polygon = begin; polygon < end; ++polygon)
    {
      const vtkIdType start = polygons.GetStart(polygon);
      const vtkIdType size = polygons.GetStart(polygon + 1) - start;
      const Id* const ids = polygons.Corners + start;
      double normal[3] = {};
      if (size == 3)
      {
        double corners[3][3];
        for (int i = 0; i < 3; ++i)
        {
          std::copy_n(places + 3 * static_cast<vtkIdType>(ids[i]), 3, corners[i]);
        }
        vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
      }
      else if (size > 3)
      {
        list->SetNumberOfIds(size);
        std::copy_n(ids, size, list->GetPointer(0));
        vtkPolygon::ComputeNormal(points, static_cast<int>(size), list->GetPointer(0), normal);
      }
      std::copy_n(normal, 3, normals.data() + 3 * polygon);
    }
  });
  return normals;
}

//------------------------------------------------------------------------------
// Writes the points' normals to `normals`; returns the splits of the points' ranges, in order.
template <typename Id>
std::vector<Splits> MakePointNormals(const Polygons<Id>& polygons, const Links& links,
  const float* ofPolygons, double leastCosine, vtkFloatArray* normals)
{
  const vtkIdType count = normals->GetNumberOfTuples();
  float* const first = normals->GetPointer(0);
  std::vector<Splits> splits(static_cast<std::size_t>((count + ChunkSize - 1) / ChunkSize));
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(splits.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      Grouping<Id> grouping(polygons, ofPolygons, leastCosine);
      for (vtkIdType point = begin * ChunkSize; point < std::min(end * ChunkSize, count); ++point)
      {
        Splits& own = splits[static_cast<std::size_t>(point / ChunkSize)];
        const FloatVector normal = grouping.Do(point, links.Begin(point), links.End(point), own);
        std::copy(normal.begin(), normal.end(), first + 3 * point);
      }
    });
  return splits;
}

//------------------------------------------------------------------------------
// Makes room for the copies after the points, and updates the corners that use them.
template <typename Id>
void PutSplits(const std::vector<Splits>& splits, vtkCellArray* cells, vtkFloatArray* normals,
  vtkPolyData* output)
{
  vtkIdType copies = 0;
  for (const Splits& each : splits)
  {
    copies += static_cast<vtkIdType>(each.Copies.size());
  }
  if (copies == 0)
  {
    return;
  }
  const vtkIdType before = normals->GetNumberOfTuples();
  vtkNew<vtkIdList> from, to; // point ids of the copies
  from->SetNumberOfIds(copies);
  to->SetNumberOfIds(copies);
  using Array = std::conditional_t<sizeof(Id) == 4, vtkTypeInt32Array, vtkTypeInt64Array>;
  vtkNew<Array> starts, moved;
  starts->ShallowCopy(cells->GetOffsetsArray());
  moved->DeepCopy(cells->GetConnectivityArray());
  vtkIdType next = before;
  for (const Splits& each : splits)
  {
    for (const Splits::Move& move : each.Moves)
    {
      moved->SetValue(move.Corner, static_cast<Id>(next + static_cast<vtkIdType>(move.To)));
    }
    for (const Splits::Copy& copy : each.Copies)
    {
      from->SetId(next - before, copy.Of);
      to->SetId(next - before, next);
      normals->InsertNextTypedTuple(copy.Normal.data());
      ++next;
    }
  }
  normals->Squeeze();
  vtkPoints* const places = output->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(places->GetDataType());
  points->SetNumberOfPoints(next);
  points->InsertPoints(0, before, 0, places);
  points->InsertPoints(to, from, places);
  vtkNew<vtkPolyData> whole;
  whole->ShallowCopy(output);
  vtkPointData* const data = output->GetPointData();
  data->Initialize();
  data->CopyAllOn();
  data->CopyAllocate(whole->GetPointData(), next);
  data->CopyData(whole->GetPointData(), 0, before, 0);
  data->CopyData(whole->GetPointData(), from, to);
  output->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(starts.Get(), moved.Get());
  output->SetPolys(polygons);
}
}

//------------------------------------------------------------------------------
int vtkRelievoPointNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->MakeNormals(vtkPolyData::GetData(inputs[0]), vtkPolyData::GetData(outputs));
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoPointNormals::MakeNormals(vtkPolyData* input, vtkPolyData* output)
{
  if (!input || !output)
  {
    vtkErrorMacro(
      "MakeNormals was given no " << (input ? "output" : "input") << "; give it two meshes.");
    return;
  }
  output->ShallowCopy(input);
  vtkCellArray* cells = input->GetPolys();
  if (!input->GetPoints() || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  if (cells->GetNumberOfConnectivityIds() > std::numeric_limits<std::uint32_t>::max())
  {
    vtkErrorMacro("expected polygons with at most 4294967295 corners, not "
      << cells->GetNumberOfConnectivityIds() << ": take a part of the mesh");
    return;
  }
  const double leastCosine = std::cos(vtkMath::RadiansFromDegrees(this->FeatureAngle));
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(input->GetNumberOfPoints());
  vtkSmartPointer<vtkDataArray> places = input->GetPoints()->GetData();
  if (!vtkFloatArray::FastDownCast(places) && !vtkDoubleArray::FastDownCast(places))
  {
    places = vtkSmartPointer<vtkDoubleArray>::New();
    places->DeepCopy(input->GetPoints()->GetData());
  }
  const auto make = [&](const auto& starts, const auto& corners) {
    using Id = std::decay_t<decltype(corners->GetValue(0))>;
    const Polygons<Id> polygons = { starts->GetPointer(0), corners->GetPointer(0),
      cells->GetNumberOfCells() };
    std::vector<float> ofPolygons;
    if (auto* floats = vtkFloatArray::FastDownCast(places))
    {
      ofPolygons = MakePolygonNormals(floats->GetPointer(0), input->GetPoints(), polygons);
    }
    else
    {
      ofPolygons = MakePolygonNormals(
        vtkDoubleArray::FastDownCast(places)->GetPointer(0), input->GetPoints(), polygons);
    }
    this->UpdateProgress(0.2);
    if (this->GetAbortExecute())
    {
      return;
    }
    Links links(polygons, input->GetNumberOfPoints());
    this->UpdateProgress(0.4);
    if (this->GetAbortExecute())
    {
      return;
    }
    const std::vector<Splits> splits =
      MakePointNormals(polygons, links, ofPolygons.data(), leastCosine, normals);
    this->UpdateProgress(0.9);
    links = Links();
    ofPolygons = std::vector<float>();
    PutSplits<Id>(splits, cells, normals, output);
    output->GetPointData()->SetNormals(normals);
  };
  using Small = vtkAOSDataArrayTemplate<vtkTypeInt32>;
  using Large = vtkAOSDataArrayTemplate<vtkTypeInt64>;
  vtkDataArray* const starts = cells->GetOffsetsArray();
  vtkDataArray* const corners = cells->GetConnectivityArray();
  if (Small::FastDownCast(starts) && Small::FastDownCast(corners))
  {
    make(Small::FastDownCast(starts), Small::FastDownCast(corners));
  }
  else if (Large::FastDownCast(starts) && Large::FastDownCast(corners))
  {
    make(Large::FastDownCast(starts), Large::FastDownCast(corners));
  }
  else // computed, or of another integer type
  {
    vtkNew<vtkTypeInt64Array> allStarts, allCorners;
    allStarts->DeepCopy(starts);
    allCorners->DeepCopy(corners);
    make(allStarts, allCorners);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPointNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
