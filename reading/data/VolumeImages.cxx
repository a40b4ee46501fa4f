// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeImages.h"

#include "Numbers.h"
#include "OptionRows.h"
#include "Progress.h"
#include "Values.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkDiscreteFlyingEdges3D.h"
#include "vtkExtractVOI.h"
#include "vtkFlyingEdges3D.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkIdList.h"
#include "vtkImageConstantPad.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace reading
{
namespace
{
constexpr int Bins = 256;
constexpr std::size_t MostLabels = 2000;
// Limit of samples visited for all labels of an image without regions, each in its own box.
constexpr double MostSamples = 1e8;
// Least share of equal neighbours along x in images of regions: noise and steep gradients have far
// fewer.
constexpr double LeastEqual = 0.6;
// Least share of jumps by more than 1 among unequal neighbours: in gradients of bytes hardly any.
constexpr double LeastLeaps = 0.25;
// Tolerance of equal places, as a share of the image's diagonal.
constexpr double SameShare = 1e-6;

// Sample distance of a volume, as a share of the distance of its points.
constexpr double SampleShare = 0.5;
// Differences between neighbours from which a sample stops all its light, as a share of the range.
constexpr double EvenShare = 0.002;
constexpr double EvenLabels = 0.1;  // for labels, which differ by at least 1
constexpr double LeastShare = 1e-9; // least share of light stopped
constexpr double MostOpacity = 0.7; // per hundredth of the image's diagonal

using Extent = std::array<int, 6>;

bool IsWhole(int type)
{
  return type != VTK_FLOAT && type != VTK_DOUBLE && type != VTK_BIT;
}

// The extent of each non-zero value; stops at one value more than MostLabels.
std::map<double, Extent> FindLabels(vtkImageData* image)
{
  int whole[6];
  image->GetExtent(whole);
  std::map<double, Extent> labels;
  const auto values = vtk::DataArrayValueRange<1>(image->GetPointData()->GetScalars());
  auto value = values.begin();
  double last = 0.0;
  Extent* box = nullptr; // of the previous value
  for (int z = whole[4]; z <= whole[5]; ++z)
  {
    for (int y = whole[2]; y <= whole[3]; ++y)
    {
      for (int x = whole[0]; x <= whole[1]; ++x, ++value)
      {
        const double label = static_cast<double>(*value);
        if (label == 0.0 || !std::isfinite(label))
        {
          continue;
        }
        if (!box || label != last)
        {
          if (labels.size() > MostLabels)
          {
            return labels;
          }
          box = &labels.try_emplace(label, Extent{ x, x, y, y, z, z }).first->second;
          last = label;
        }
        const int place[3] = { x, y, z };
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          (*box)[2 * axis] = std::min((*box)[2 * axis], place[axis]);
          (*box)[2 * axis + 1] = std::max((*box)[2 * axis + 1], place[axis]);
        }
      }
    }
  }
  return labels;
}

// Hues a golden section apart, so that neighbouring numbers differ; soft, so that shading is
// visible.
std::array<unsigned char, 3> GetLabelColor(std::size_t number)
{
  constexpr double GoldenSection = 0.618033988749895;
  const double hue = 0.58 + GoldenSection * static_cast<double>(number);
  const double hsv[3] = { hue - std::floor(hue), number % 2 == 0 ? 0.45 : 0.6,
    number % 3 == 0 ? 0.95 : 0.85 };
  double rgb[3];
  vtkMath::HSVToRGB(hsv, rgb);
  std::array<unsigned char, 3> bytes;
  std::transform(rgb, rgb + 3, bytes.begin(),
    [](double part) { return static_cast<unsigned char>(std::lround(255.0 * part)); });
  return bytes;
}

// The image along the axes of its indices: some filters apply a direction matrix, others do not.
vtkSmartPointer<vtkImageData> WithoutDirection(vtkImageData* image)
{
  auto upright = vtkSmartPointer<vtkImageData>::New();
  upright->ShallowCopy(image);
  upright->SetDirectionMatrix(vtkNew<vtkMatrix3x3>());
  return upright;
}

// Transforms the result to world coordinates.
vtkSmartPointer<vtkPolyData> WithDirection(vtkPolyData* mesh, vtkImageData* image)
{
  vtkMatrix3x3* direction = image->GetDirectionMatrix();
  if (direction->IsIdentity() || mesh->GetNumberOfPoints() == 0)
  {
    return mesh;
  }
  const double* origin = image->GetOrigin();
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    vtkMath::Subtract(point, origin, point);
    direction->MultiplyPoint(point, point);
    vtkMath::Add(point, origin, point);
    points->SetPoint(i, point);
  }
  mesh->SetPoints(points);
  return TurnOutwards(mesh, image);
}

// Surface of a region, closed at the image's border. Its cells carry the label and the colour.
vtkSmartPointer<vtkPolyData> MakeRegion(
  vtkImageData* image, double label, const Extent& box, const std::array<unsigned char, 3>& color)
{
  int whole[6];
  image->GetExtent(whole);
  Extent around = box;
  Extent padded = box;
  for (std::size_t i = 0; i < 6; ++i)
  {
    padded[i] += i % 2 == 0 ? -1 : 1;
    around[i] = i % 2 == 0 ? std::max(whole[i], padded[i]) : std::min(whole[i], padded[i]);
  }
  vtkNew<vtkExtractVOI> part;
  part->SetInputData(image);
  part->SetVOI(around.data());
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputConnection(part->GetOutputPort());
  pad->SetOutputWholeExtent(padded.data());
  pad->SetConstant(0.0); // 0 is no label
  vtkNew<vtkDiscreteFlyingEdges3D> surface;
  surface->SetInputConnection(pad->GetOutputPort());
  surface->SetValue(0, label);
  surface->ComputeNormalsOff();
  surface->ComputeGradientsOff();
  surface->ComputeScalarsOff();
  surface->Update();
  vtkSmartPointer<vtkPolyData> made = surface->GetOutput();
  const vtkIdType cells = made->GetNumberOfCells();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const auto labels = vtk::TakeSmartPointer(scalars->NewInstance());
  labels->SetName(scalars->GetName() ? scalars->GetName() : "label");
  labels->SetNumberOfTuples(cells);
  labels->Fill(label);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(cells);
  for (int i = 0; i < 3; ++i)
  {
    colors->FillComponent(i, color[static_cast<std::size_t>(i)]);
  }
  made->GetPointData()->Initialize();
  made->GetCellData()->Initialize();
  made->GetCellData()->AddArray(labels);
  made->GetCellData()->SetScalars(colors);
  return made;
}
}

//------------------------------------------------------------------------------
ImageChoice ParseImage(const std::string& word)
{
  using Kind = ImageChoice::Kind;
  ImageChoice choice;
  const std::string::size_type equals = word.find('=');
  if (word.substr(0, equals) == "surface")
  {
    choice.Is = Kind::Surface;
    if (equals != std::string::npos)
    {
      choice.Value = ParseNumbers("--image surface", word.substr(equals + 1), 1, "VALUE").front();
    }
    return choice;
  }
  constexpr Kind kinds[] = { Kind::Found, Kind::Box, Kind::Labels, Kind::Volume };
  choice.Is = kinds[ParseChoice("--image", word, { "auto", "box", "labels", "volume", "surface" })];
  return choice;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GetVolumeImage(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image || image->GetDataDimension() != 3)
  {
    return nullptr;
  }
  vtkDataArray* ofPoints = image->GetPointData()->GetScalars();
  vtkDataArray* ofCells = image->GetCellData()->GetScalars();
  vtkDataArray* values = ofPoints ? ofPoints : ofCells;
  if (!values || values->GetNumberOfComponents() != 1 || values->GetDataType() == VTK_BIT)
  {
    return nullptr;
  }
  auto made = vtkSmartPointer<vtkImageData>::New();
  if (ofPoints)
  {
    made->ShallowCopy(image);
    return made;
  }
  int extent[6];
  image->GetExtent(extent);
  double origin[3];
  image->GetOrigin(origin);
  const double half[3] = { 0.5 * image->GetSpacing()[0], 0.5 * image->GetSpacing()[1],
    0.5 * image->GetSpacing()[2] };
  double shift[3];
  image->GetDirectionMatrix()->MultiplyPoint(half, shift);
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] += shift[axis];
    --extent[2 * axis + 1];
    if (extent[2 * axis] == extent[2 * axis + 1])
    {
      return nullptr; // a single layer of cells
    }
  }
  made->SetExtent(extent);
  made->SetOrigin(origin);
  made->SetSpacing(image->GetSpacing());
  made->SetDirectionMatrix(image->GetDirectionMatrix());
  made->GetPointData()->ShallowCopy(image->GetCellData());
  return made;
}

//------------------------------------------------------------------------------
bool HasLabels(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!IsWhole(scalars->GetDataType()))
  {
    return false;
  }
  const int row = image->GetDimensions()[0];
  const auto values = vtk::DataArrayValueRange<1>(scalars);
  vtkIdType equal = 0;
  vtkIdType pairs = 0;
  vtkIdType leaps = 0;
  for (vtkIdType i = 1; i < values.size(); ++i)
  {
    const double a = static_cast<double>(values[i - 1]);
    const double b = static_cast<double>(values[i]);
    const bool empty = a == 0.0 && b == 0.0; // background, common to most images
    const bool counts = i % row != 0 && !empty;
    pairs += counts ? 1 : 0;
    equal += counts && a == b ? 1 : 0;
    leaps += counts && std::abs(a - b) > 1.0 ? 1 : 0;
  }
  const std::size_t labels = FindLabels(image).size();
  const bool even = static_cast<double>(equal) >= LeastEqual * static_cast<double>(pairs) &&
    static_cast<double>(leaps) >= LeastLeaps * static_cast<double>(pairs - equal);
  return labels == 1 || (labels > 1 && labels <= MostLabels && even);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> TurnOutwards(vtkPolyData* surface, vtkImageData* image)
{
  if (image->GetDataDimension() < 3 || image->GetDirectionMatrix()->Determinant() >= 0.0)
  {
    return surface;
  }
  vtkNew<vtkReverseSense> turned;
  turned->SetInputData(surface);
  turned->Update();
  return turned->GetOutput();
}

//------------------------------------------------------------------------------
std::string CheckLabels(vtkImageData* image)
{
  const std::map<double, Extent> labels = FindLabels(image);
  if (labels.size() > MostLabels)
  {
    return "holds more than " + std::to_string(MostLabels) + " values";
  }
  double samples = 0.;
  for (const auto& [label, box] : labels)
  {
    samples += (box[1] - box[0] + 1.) * (box[3] - box[2] + 1.) * (box[5] - box[4] + 1.);
  }
  return samples > MostSamples && !HasLabels(image) ? "holds " + std::to_string(labels.size()) +
      " values that change from nearly every point to the next, expected regions of equal values"
                                                    : "";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeLabelSurfaces(vtkImageData* image, Progress& progress)
{
  const std::map<double, Extent> labels = FindLabels(image);
  const vtkSmartPointer<vtkImageData> upright = WithoutDirection(image);
  vtkNew<vtkAppendPolyData> all;
  std::size_t number = 0;
  for (const auto& [label, box] : labels)
  {
    all->AddInputData(MakeRegion(upright, label, box, GetLabelColor(number)));
    progress.Update(static_cast<double>(++number) / static_cast<double>(labels.size()));
  }
  if (all->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  // Adjacent regions share their boundary points, so that no gap opens between them.
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputConnection(all->GetOutputPort());
  joined->SetTolerance(SameShare);
  joined->ConvertPolysToLinesOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(joined->GetOutputPort());
  smooth->SetNumberOfIterations(20);
  smooth->SetPassBand(0.01);
  smooth->NormalizeCoordinatesOn();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NonManifoldSmoothingOn();
  progress.Observe(smooth);
  smooth->Update();
  return WithDirection(smooth->GetOutput(), image);
}

//------------------------------------------------------------------------------
double FindThreshold(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  double range[2];
  scalars->GetFiniteRange(range);
  std::vector<double> histogram(Bins, 0.0);
  double count = 0.0;
  double sum = 0.0;
  for (const auto each : vtk::DataArrayValueRange<1>(scalars))
  {
    const double value = static_cast<double>(each);
    if (std::isfinite(value) && range[0] < range[1])
    {
      const double place = Bins * (value - range[0]) / (range[1] - range[0]);
      const int bin = std::min(Bins - 1, static_cast<int>(place));
      histogram[static_cast<std::size_t>(bin)] += 1.0;
      count += 1.0;
      sum += bin;
    }
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  int first = 0;
  int last = 0;
  for (int bin = 0; bin < Bins - 1; ++bin)
  {
    below += histogram[static_cast<std::size_t>(bin)];
    sumBelow += bin * histogram[static_cast<std::size_t>(bin)];
    const double above = count - below;
    if (below == 0.0 || above == 0.0)
    {
      continue;
    }
    const double apart = sumBelow / below - (sum - sumBelow) / above;
    const double variance = below * above * apart * apart;
    first = variance > best ? bin : first;
    last = variance >= best ? bin : last;
    best = std::max(best, variance);
  }
  // The middle of the gap, where every value separates equally well; in few digits, for
  // readability.
  const double width = range[1] - range[0];
  const double exact = range[0] + width * (0.5 * (first + last) + 1.0) / Bins;
  const double rounded = RoundTo(exact, 1e-3 * width);
  return range[0] < rounded && rounded < range[1] ? rounded : exact;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeIsosurface(vtkImageData* image, double value, Progress& progress)
{
  vtkNew<vtkFlyingEdges3D> surface;
  progress.Observe(surface);
  surface->SetInputData(WithoutDirection(image));
  surface->SetValue(0, value);
  surface->ComputeNormalsOff();
  surface->InterpolateAttributesOn();
  surface->Update();
  const vtkSmartPointer<vtkPolyData> made = WithDirection(surface->GetOutput(), image);
  made->GetPointData()->SetActiveScalars(nullptr); // a single value gives no colours
  return made;
}

namespace
{
// The opacity of a new volume, per hundredth of the image's diagonal: finding it takes time.
class FoundOpacity : public vtkPiecewiseFunction
{
public:
  static FoundOpacity* New();
  vtkTypeMacro(FoundOpacity, vtkPiecewiseFunction);
};

vtkStandardNewMacro(FoundOpacity);

// Copies the values of points or cells in the opposite order along an axis.
void Reverse(vtkDataSetAttributes* from, const std::array<vtkIdType, 3>& size, int axis,
  vtkDataSetAttributes* to)
{
  const auto [columns, rows, slices] = size;
  to->CopyAllOn();
  to->CopyAllocate(from, columns * rows * slices);
  vtkNew<vtkIdList> source, target; // a row
  source->SetNumberOfIds(columns);
  target->SetNumberOfIds(columns);
  for (vtkIdType row = 0; row < rows * slices; ++row)
  {
    const vtkIdType j = row % rows, k = row / rows;
    const vtkIdType other =
      (axis == 2 ? slices - 1 - k : k) * rows + (axis == 1 ? rows - 1 - j : j);
    for (vtkIdType i = 0; i < columns; ++i)
    {
      source->SetId(i, other * columns + (axis == 0 ? columns - 1 - i : i));
      target->SetId(i, row * columns + i);
    }
    to->CopyData(from, source, target);
  }
}

// An image with left-handed axes in the opposite order along one of them: VTK culls the front of
// such a volume. The axis is the one that points most against its own of the world, because VTK
// shades by the gradients of images without a direction.
vtkSmartPointer<vtkImageData> WithRightHandedAxes(vtkImageData* image)
{
  vtkMatrix3x3* direction = image->GetDirectionMatrix();
  if (direction->Determinant() >= 0.0)
  {
    return image;
  }
  int axis = 0;
  for (const int other : { 1, 2 })
  {
    axis = direction->GetElement(other, other) < direction->GetElement(axis, axis) ? other : axis;
  }
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->CopyStructure(image);
  const int* extent = image->GetExtent() + 2 * axis;
  double origin[3];
  vtkNew<vtkMatrix3x3> turned;
  turned->DeepCopy(direction);
  for (int k = 0; k < 3; ++k)
  {
    const double along = direction->GetElement(k, axis);
    origin[k] = image->GetOrigin()[k] + along * image->GetSpacing()[axis] * (extent[0] + extent[1]);
    turned->SetElement(k, axis, -along);
  }
  made->SetOrigin(origin);
  made->SetDirectionMatrix(turned);
  std::array<vtkIdType, 3> points, cells;
  for (std::size_t k = 0; k < 3; ++k)
  {
    points[k] = image->GetDimensions()[k];
    cells[k] = std::max<vtkIdType>(1, points[k] - 1);
  }
  Reverse(image->GetPointData(), points, axis, made->GetPointData());
  made->GetCellData()->Initialize(); // CopyStructure has passed the blanked cells
  Reverse(image->GetCellData(), cells, axis, made->GetCellData());
  return made;
}

vtkSmartPointer<vtkPiecewiseFunction> MakeOpacity(vtkImageData* image)
{
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range);
  auto opacity = vtkSmartPointer<FoundOpacity>::New();
  if (HasLabels(image)) // all labels are visible but 0, the background
  {
    opacity->AddPoint(-0.5, MostOpacity);
    opacity->AddPoint(-0.25, 0.0);
    opacity->AddPoint(0.25, 0.0);
    opacity->AddPoint(0.5, MostOpacity);
  }
  else
  {
    const double threshold = FindThreshold(image);
    opacity->AddPoint(range[0], 0.0);
    opacity->AddPoint(range[0] + 0.8 * (threshold - range[0]), 0.0);
    opacity->AddPoint(threshold, 0.15);
    opacity->AddPoint(range[1], MostOpacity);
  }
  return opacity;
}
}

//------------------------------------------------------------------------------
void SetVolumeOpacity(vtkVolume* volume, double opacity)
{
  auto* image = vtkImageData::SafeDownCast(volume->GetMapper()->GetInputDataObject(0, 0));
  const double share = std::max(opacity * opacity, LeastShare);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.01 * image->GetLength() / share);
}

//------------------------------------------------------------------------------
void SetVolumeCurve(vtkVolume* volume, const std::vector<std::array<double, 2>>& curve)
{
  auto* image = vtkImageData::SafeDownCast(volume->GetMapper()->GetInputDataObject(0, 0));
  if (curve.empty())
  {
    if (FoundOpacity::SafeDownCast(volume->GetProperty()->GetScalarOpacity()))
    {
      return;
    }
    volume->GetProperty()->SetScalarOpacity(MakeOpacity(image));
    return;
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const std::array<double, 2>& point : curve)
  {
    opacity->AddPoint(point[0], point[1]);
  }
  volume->GetProperty()->SetScalarOpacity(opacity);
}

//------------------------------------------------------------------------------
void SetVolumeStep(vtkVolume* volume, double share)
{
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  auto* image = vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  // VTK's own choice is half the distance of the points, and finer in images of few points.
  mapper->SetLockSampleDistanceToInputSpacing(share == SampleShare);
  mapper->SetSampleDistance(
    static_cast<float>(share * *std::min_element(image->GetSpacing(), image->GetSpacing() + 3)));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolume> MakeVolume(vtkImageData* image)
{
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range);
  const bool labels = HasLabels(image);
  const vtkSmartPointer<vtkPiecewiseFunction> opacity = MakeOpacity(image);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(WithRightHandedAxes(image));
  // The default would adapt the sample distance to the time of earlier frames.
  mapper->AutoAdjustSampleDistancesOff();
  volume->SetMapper(mapper);
  SetVolumeStep(volume, SampleShare);
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetScalarOpacity(opacity);
  SetVolumeOpacity(volume, 1.0);
  // Between labels 2 and 6 there is no 4.
  property->SetInterpolationType(labels ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  property->ShadeOn();
  // Volumes are as bright as surfaces.
  property->SetDiffuse(1.0);
  property->SetSpecular(0.1);
  if (range[0] < range[1])
  {
    // Where all values around a sample are equal, as within labels, it has no gradient to shade by
    // and would be black.
    vtkNew<vtkPiecewiseFunction> even;
    even->AddPoint(0.0, 0.0);
    even->AddPoint(labels ? EvenLabels : EvenShare * (range[1] - range[0]), 1.0);
    property->SetGradientOpacity(even);
  }
  return volume;
}

//------------------------------------------------------------------------------
void AddImageOption(OptionRows& rows, ImageChoice& image)
{
  rows
    .Add("--image", "KIND",
      "how images with depth (.vti, .pvti, .vtk) are shown: labels, the smooth surface of "
      "each value other than 0, for at most 2000 values; surface[=VALUE], the surface at "
      "VALUE (the threshold that separates the values best); volume; box, the outer faces; "
      "auto, labels if the image consists of labels, at most 2000, else surface (auto with "
      "a preset and without --color-by and --scalar-bar, else box)",
      [&image](const std::string& word) { image = ParseImage(word); })
    .Is(OptionRows::Option::READS_FILES)
    .NamedIn("Scene", "Images")
    .DropAs("how the image is shown")
    .Words = { "auto", "labels", "surface", "volume", "box" };
}
}
