// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCover.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoAbort.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoRayTree.h"
#include "vtkRelievoSurfacePlaces.h"
#include "vtkRelievoThreads.h"
#include "vtkSMPTools.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

vtkStandardNewMacro(vtkRelievoCover);

namespace
{
constexpr std::size_t BitsOfAWord = 64;

// Which cells each candidate sees: a row of bits each.
class SightTable
{
public:
  SightTable(std::size_t candidates, std::size_t cells)
    : Words((cells + BitsOfAWord - 1) / BitsOfAWord)
    , Bits(candidates * Words)
  {
  }

  static double GetBytes(std::size_t candidates, std::size_t cells)
  {
    return static_cast<double>(candidates) * static_cast<double>(cells) / 8.0;
  }

  void Set(std::size_t candidate, std::size_t cell)
  {
    this->Bits[candidate * this->Words + cell / BitsOfAWord] |= std::uint64_t(1)
      << cell % BitsOfAWord;
  }

  // Calls visit(cell) for each cell that the candidate sees, in their order.
  template <typename Visit>
  void ForEach(std::size_t candidate, const Visit& visit) const
  {
    const std::uint64_t* words = this->Bits.data() + candidate * this->Words;
    for (std::size_t word = 0; word < this->Words; ++word)
    {
      for (std::uint64_t bits = words[word]; bits != 0; bits &= bits - 1)
      {
        visit(word * BitsOfAWord + static_cast<std::size_t>(__builtin_ctzll(bits)));
      }
    }
  }

private:
  std::size_t Words;
  std::vector<std::uint64_t> Bits;
};

// Limits of a camera's sight.
struct Limits
{
  double Farthest; // 0: none
  double LeastCosine;
  double LeastAhead; // cosine to the camera's direction; at most -1: any
  double Resolution; // pixels per world unit
  double FocalLength;
};

// Fills the rows of a table.
class Viewer
{
public:
  Viewer(const vtkRelievoRayTree& tree, const vtkRelievoSurfacePlaces& places, double before,
    const Limits& limits)
    : Tree(tree)
    , Places(places)
    , Before(before)
    , Allowed(limits)
  {
  }

  void Look(
    const glm::dvec3& from, const glm::dvec3& ahead, std::size_t candidate, SightTable& table) const
  {
    // The segments end before the candidate, which may lie on a surface.
    constexpr double end = 1.0 - 1e-9;
    for (std::size_t cell = 0; cell < this->Places.At.size(); ++cell)
    {
      glm::dvec3 place;
      glm::dvec3 direction;
      double distance = 0.0;
      if (this->Aim(cell, from, ahead, place, direction, distance) &&
        !this->Tree.HitsAny(place, direction, 0.0, end * distance))
      {
        table.Set(candidate, cell);
      }
    }
  }

private:
  // The segment from a cell to a candidate, in the tree's coordinates; false if the limits exclude
  // it.
  bool Aim(std::size_t cell, const glm::dvec3& from, const glm::dvec3& ahead, glm::dvec3& place,
    glm::dvec3& direction, double& distance) const
  {
    const glm::dvec3 normal = glm::make_vec3(this->Places.Normals[cell].data());
    place = glm::make_vec3(this->Places.At[cell].data());
    glm::dvec3 to = from - place;
    const double height = glm::dot(to, normal);
    if (height < 0.0) // seen from behind
    {
      place -= 2.0 * this->Before * normal;
      to = from - place;
    }
    distance = glm::length(to);
    const double cosine = distance > 0.0 ? std::abs(glm::dot(to, normal)) / distance : 0.0;
    const Limits& limits = this->Allowed;
    if (!(cosine > 0.0) || cosine < limits.LeastCosine ||
      (limits.Farthest > 0.0 && distance > limits.Farthest) ||
      limits.FocalLength * cosine < limits.Resolution * distance ||
      (limits.LeastAhead > -1.0 && !(-glm::dot(to, ahead) >= limits.LeastAhead * distance)))
    {
      return false;
    }
    place -= this->Tree.GetCenter();
    direction = to / distance;
    return true;
  }

  const vtkRelievoRayTree& Tree;
  const vtkRelievoSurfacePlaces& Places;
  double Before; // the distance of places from their surface
  Limits Allowed;
};

// The choice of candidates, one after the other.
class Choice
{
public:
  Choice(
    const SightTable& table, std::size_t candidates, const std::vector<double>& weights, int times)
    : Table(table)
    , Weights(weights)
    , Times(times)
    , Counts(weights.size())
    , Gains(candidates)
    , Taken(candidates)
  {
    for (std::size_t i = 0; i < candidates; ++i)
    {
      this->Gains[i] = this->GetGain(i);
      this->Queue.push({ this->Gains[i], i, 0 });
    }
    this->FirstGains = this->Gains;
  }

  // Takes the candidate with the largest gain, the first one of several; false if none gains.
  // Gains only shrink, so that an old gain is a bound: most are never computed again.
  bool TakeNext(std::size_t& candidate, double& gain)
  {
    while (!this->Queue.empty())
    {
      Entry entry = this->Queue.top();
      this->Queue.pop();
      if (entry.Round != this->Round)
      {
        entry.Gain = this->GetGain(entry.Candidate);
        entry.Round = this->Round;
        this->Queue.push(entry);
        continue;
      }
      if (!(entry.Gain > 0.0))
      {
        return false;
      }
      candidate = entry.Candidate;
      gain = entry.Gain;
      this->Sum += gain;
      this->Taken[candidate] = true;
      this->Table.ForEach(candidate, [this](std::size_t cell) { ++this->Counts[cell]; });
      ++this->Round;
      return true;
    }
    return false;
  }

  // An upper bound of the weight that so many candidates can cover: for any set, the weight covered
  // and the largest gains on top of it (monotone submodular functions), of which the smaller one.
  double GetBound(int places)
  {
    std::vector<double> last(this->Gains.size());
    for (std::size_t i = 0; i < last.size(); ++i)
    {
      last[i] = this->Taken[i] ? 0.0 : this->GetGain(i);
    }
    return std::min(SumLargest(this->FirstGains, places), this->Sum + SumLargest(last, places));
  }

  double GetSum() const { return this->Sum; }
  const std::vector<int>& GetCounts() const { return this->Counts; }

private:
  struct Entry
  {
    double Gain;
    std::size_t Candidate;
    int Round; // number of candidates taken when the gain was computed
    bool operator<(const Entry& other) const
    {
      return this->Gain != other.Gain ? this->Gain < other.Gain : this->Candidate > other.Candidate;
    }
  };

  double GetGain(std::size_t candidate) const
  {
    double gain = 0.0;
    this->Table.ForEach(candidate, [&](std::size_t cell) {
      gain += this->Counts[cell] < this->Times ? this->Weights[cell] : 0.0;
    });
    return gain;
  }

  static double SumLargest(std::vector<double> gains, int count)
  {
    const auto most = std::min(gains.size(), static_cast<std::size_t>(count));
    std::partial_sort(gains.begin(), gains.begin() + static_cast<std::ptrdiff_t>(most), gains.end(),
      std::greater<>());
    double sum = 0.0;
    for (std::size_t i = 0; i < most; ++i)
    {
      sum += gains[i];
    }
    return sum;
  }

  const SightTable& Table;
  const std::vector<double>& Weights;
  int Times;
  int Round = 0;
  double Sum = 0.0;
  std::vector<int> Counts; // of taken candidates, per cell
  std::vector<double> Gains, FirstGains;
  std::vector<bool> Taken;
  std::priority_queue<Entry> Queue;
};

void AddCounts(vtkPolyData* mesh, const char* name, const std::vector<int>& counts)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(counts.size()));
  std::copy(counts.begin(), counts.end(), array->GetPointer(0));
  mesh->GetCellData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
vtkRelievoCover::vtkRelievoCover()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
  vtkRelievoParameterList& list = this->Parameters;
  const double infinity = vtkMath::Inf();
  list.AddWhole(
    "number_of_places", this->NumberOfPlaces,
    [this](int places) { this->SetNumberOfPlaces(places); }, 1, VTK_INT_MAX, "",
    "How many places to choose.");
  list.AddWhole(
    "times", this->Times, [this](int times) { this->SetTimes(times); }, 1, 16, "",
    "How many chosen places should see each cell.");
  list.AddNumber(
    "farthest_distance", this->FarthestDistance,
    [this](double distance) { this->SetFarthestDistance(distance); }, 0.0, infinity, "",
    "The largest distance at which a cell is seen, in world units; 0: any.");
  list.AddNumber(
    "largest_angle", this->LargestAngle, [this](double degrees) { this->SetLargestAngle(degrees); },
    1.0, 90.0, "degrees", "The largest angle between the line of sight and the cell's normal.");
  list.AddNumber(
    "view_angle", this->ViewAngle, [this](double degrees) { this->SetViewAngle(degrees); }, 1.0,
    360.0, "degrees", "The full angle of the cone that a camera sees; 360: everything.");
  list.AddNumber(
    "resolution", this->Resolution, [this](double pixels) { this->SetResolution(pixels); }, 0.0,
    infinity, "", "The fewest pixels per world unit on the surface; 0: any.");
  list
    .AddNumber(
      "focal_length", this->FocalLength, [this](double pixels) { this->SetFocalLength(pixels); },
      0.0, infinity, "pixels", "Pixels per radian in the middle of a camera, for Resolution.")
    .Open = true;
  list.AddText(
    "weights", [this] { return this->Weights; },
    [this](const std::string& name) { this->SetWeights(name.c_str()); },
    "The name of a cell array of weights per area; empty: 1.");
}

//------------------------------------------------------------------------------
void vtkRelievoCover::SetWeights(RELIEVO_TEXT name)
{
  const std::string text = name;
  if (text != this->Weights)
  {
    this->Weights = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoCover::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port < 2)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoCover::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkDataSet* candidates = vtkDataSet::GetData(inputs[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* chosen = vtkPolyData::GetData(outputs, 1);
  const auto count = static_cast<std::size_t>(candidates->GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(mesh->GetNumberOfCells());
  vtkDataArray* directions = candidates->GetPointData()->GetVectors();
  const bool isEverywhere = this->ViewAngle >= 360.0;
  if (this->GetNumberOfParts() > 1)
  {
    vtkErrorMacro(
      "A choice of places has no parts: each place depends on those before it; expected "
      "1 of 1.");
    return 1;
  }
  if (count == 0)
  {
    vtkErrorMacro("There are no candidates; give points as input 2.");
    return 1; // status 0 would make the executive print an internal error
  }
  if (!isEverywhere && !directions)
  {
    vtkErrorMacro("The candidates have no directions; give them active point vectors, or a "
                  "ViewAngle of 360.");
    return 1;
  }
  vtkDataArray* given =
    this->Weights.empty() ? nullptr : mesh->GetCellData()->GetArray(this->Weights.c_str());
  if (!this->Weights.empty() && (!given || given->GetNumberOfComponents() != 1))
  {
    vtkErrorMacro(
      "Weights: got " << this->Weights << ", expected the name of a cell array of one component.");
    return 1;
  }
  const std::string lack = relievo::LackOfMemory(SightTable::GetBytes(count, cells), 0.0);
  if (!lack.empty())
  {
    vtkErrorMacro(<< count << " candidates of " << cells << " cells need a bit each: " << lack);
    return 1;
  }
  vtkRelievoSurfacePlaces places;
  places.TakeCells(mesh);
  std::vector<double> weights(cells);
  double all = 0.0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    const double each = given ? given->GetComponent(static_cast<vtkIdType>(cell), 0) : 1.0;
    if (!(each >= 0.0 && std::isfinite(each)))
    {
      vtkErrorMacro(
        "Weights: got " << each << " for cell " << cell << ", expected numbers of at least 0.");
      return 1;
    }
    weights[cell] = each * places.Areas[cell];
    all += weights[cell] * this->Times;
  }

  const vtkSmartPointer<vtkRelievoRayScene> scene = this->MakeScene(inputs);
  if (!scene)
  {
    return 1;
  }
  Limits limits;
  limits.Farthest = this->FarthestDistance;
  limits.LeastCosine = std::cos(vtkMath::RadiansFromDegrees(this->LargestAngle)) * (1.0 - 1e-12);
  limits.LeastAhead =
    isEverywhere ? -2.0 : std::cos(vtkMath::RadiansFromDegrees(0.5 * this->ViewAngle));
  limits.Resolution = this->Resolution;
  limits.FocalLength = this->FocalLength;
  SightTable table(count, cells);
  const Viewer viewer(scene->GetTree(), places, places.Before, limits);
  // Between two reports of progress, some work for each thread.
  const std::size_t batch = std::max<std::size_t>(
    16, 8 * static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads()));
  for (std::size_t first = 0; first < count; first += batch)
  {
    const std::size_t end = std::min(count, first + batch);
    vtkRelievoWithThreads([&] {
      vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(end), 1,
        [&](vtkIdType from, vtkIdType to) {
          for (vtkIdType i = from; i < to; ++i)
          {
            glm::dvec3 place;
            glm::dvec3 ahead(0.0);
            candidates->GetPoint(i, &place.x);
            if (directions)
            {
              directions->GetTuple(i, &ahead.x);
              ahead = glm::length(ahead) > 0.0 ? glm::normalize(ahead) : ahead;
            }
            viewer.Look(place, ahead, static_cast<std::size_t>(i), table);
          }
        });
    });
    this->UpdateProgress(static_cast<double>(end) / static_cast<double>(count));
    if (relievo::IsStopped(this))
    {
      relievo::Discard(outputs);
      return 1;
    }
  }

  std::vector<int> seen(cells);
  for (std::size_t i = 0; i < count; ++i)
  {
    table.ForEach(i, [&seen](std::size_t cell) { ++seen[cell]; });
  }
  double reachable = 0.0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    reachable += weights[cell] * std::min(seen[cell], this->Times);
  }
  Choice choice(table, count, weights, this->Times);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("candidate");
  vtkNew<vtkDoubleArray> gains;
  gains->SetName("gain");
  vtkNew<vtkDoubleArray> shares;
  shares->SetName("share");
  const double unit = all > 0.0 ? 1.0 / all : 0.0;
  std::size_t candidate = 0;
  double gain = 0.0;
  while (points->GetNumberOfPoints() < this->NumberOfPlaces && choice.TakeNext(candidate, gain))
  {
    const auto id = static_cast<vtkIdType>(candidate);
    const vtkIdType vertex = points->InsertNextPoint(candidates->GetPoint(id));
    vertices->InsertNextCell(1, &vertex);
    numbers->InsertNextValue(id);
    gains->InsertNextValue(gain * unit);
    shares->InsertNextValue(choice.GetSum() * unit);
  }
  output->ShallowCopy(mesh);
  AddCounts(output, "covered", choice.GetCounts());
  output->GetCellData()->SetActiveScalars("covered");
  AddCounts(output, "candidates", seen);
  AddField(output, "share", choice.GetSum() * unit);
  AddField(output, "reachable", reachable * unit);
  AddField(output, "bound", std::min(reachable, choice.GetBound(this->NumberOfPlaces)) * unit);
  chosen->SetPoints(points);
  chosen->SetVerts(vertices);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(numbers),
         static_cast<vtkDataArray*>(gains), static_cast<vtkDataArray*>(shares) })
  {
    chosen->GetPointData()->AddArray(array);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoCover::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
}
