// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoHeightsToNormals.h"

#include "vtkRelievoArrayNames.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoWholeImage.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <cmath>
#include <limits>
#include <string>

namespace f64 = relievo::f64;

vtkStandardNewMacro(vtkRelievoHeightsToNormals);

//------------------------------------------------------------------------------
vtkRelievoHeightsToNormals::vtkRelievoHeightsToNormals()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Parameters;
  list
    .AddWhole("component", vtkRelievoMember(Component), 0, VTK_INT_MAX, "",
      "The component of the array that holds the height, from 0.")
    .Advanced = true;
  list.AddNumber("height_scale", vtkRelievoMember(HeightScale), -infinity, infinity, "",
    "Units of the spacing per unit of height; a negative value turns hills into pits.");
  list.AddChoice("kernel", vtkRelievoMember(Kernel), { "central", "sobel", "fourth_order" },
    "How slopes are computed. Central: from both neighbours. Sobel: averaged over three rows, with "
    "less noise, and blurred. Fourth order: from two neighbours on each side, the most accurate "
    "for smooth heights.");
  list.AddChoice("encoding", vtkRelievoMember(Encoding), { "float", "8_bits", "16_bits" },
    "Unit vectors in float, or codes of 8 or 16 bits for files.");
  list.AddFlag("wrap_columns", vtkRelievoMember(WrapColumns),
    "Whether the map continues at the other side after its last column, as repeated textures do.");
  list.AddFlag("wrap_rows", vtkRelievoMember(WrapRows),
    "Whether the map continues at the other side after its last row.");
  list
    .AddFlag("flip_green", vtkRelievoMember(FlipGreen),
      "Whether green points to lower rows, as in DirectX.")
    .Advanced = true;
}

namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

// One axis of the map: number of texels, their stride in the array, and whether it wraps.
struct Axis
{
  vtkIdType Count;
  vtkIdType Stride;
  bool Wrap;
};

// Heights of one component of an array; NaN where unknown.
template <typename ArrayT>
class Heights
{
public:
  Heights(ArrayT* array, int component, int kernel)
    : Range(vtk::DataArrayTupleRange(array))
    , Component(component)
    , Kernel(kernel)
  {
  }

  // Difference per step along `axis` at texel `i` of the line that starts at `line`; NaN if fewer
  // than two texels are known.
  double Slope(const Axis& axis, vtkIdType line, vtkIdType i) const
  {
    const double previous = this->At(axis, line, i - 1);
    const double next = this->At(axis, line, i + 1);
    if (!std::isnan(previous) && !std::isnan(next))
    {
      const double central = 0.5 * (next - previous);
      if (this->Kernel != vtkRelievoHeightsToNormals::FOURTH_ORDER)
      {
        return central;
      }
      const double wide = this->At(axis, line, i + 2) - this->At(axis, line, i - 2);
      return std::isnan(wide) ? central : (8. * central * 2. - wide) / 12.;
    }
    const double here = this->At(axis, line, i);
    const bool ahead = std::isnan(previous);
    const double beside = ahead ? next : previous;
    const double beyond = this->At(axis, line, ahead ? i + 2 : i - 2);
    const double sign = ahead ? 1. : -1.;
    // Through the parabola of three texels; through two if there is no third.
    return sign *
      (std::isnan(beyond) ? beside - here : 2. * (beside - here) - 0.5 * (beyond - here));
  }

  // The slope of Sobel's kernel, averaged over both adjacent lines if both are known: one alone
  // would shift the slope's position.
  double SmoothSlope(
    const Axis& axis, const Axis& across, vtkIdType slice, vtkIdType i, vtkIdType j) const
  {
    const double own = this->Slope(axis, slice + j * across.Stride, i);
    const vtkIdType before = Neighbour(across, j - 1);
    const vtkIdType after = Neighbour(across, j + 1);
    if (this->Kernel != vtkRelievoHeightsToNormals::SOBEL || before < 0 || after < 0)
    {
      return own;
    }
    const double sides = this->Slope(axis, slice + before * across.Stride, i) +
      this->Slope(axis, slice + after * across.Stride, i);
    const double smooth = 0.25 * (sides + 2. * own);
    return std::isnan(smooth) ? own : smooth;
  }

private:
  // Index of an adjacent texel, wrapped, or -1 beyond the edge.
  static vtkIdType Neighbour(const Axis& axis, vtkIdType i)
  {
    if (axis.Wrap)
    {
      return (i + 2 * axis.Count) % axis.Count;
    }
    return i >= 0 && i < axis.Count ? i : -1;
  }

  double At(const Axis& axis, vtkIdType line, vtkIdType i) const
  {
    const vtkIdType index = Neighbour(axis, i);
    if (index < 0)
    {
      return Unknown;
    }
    const double height =
      static_cast<double>(this->Range[line + index * axis.Stride][this->Component]);
    return std::isfinite(height) ? height : Unknown;
  }

  decltype(vtk::DataArrayTupleRange(std::declval<ArrayT*>())) Range;
  int Component;
  int Kernel;
};

// The work that does not depend on the type of the heights.
struct Work
{
  Axis Columns;
  Axis Rows;
  vtkIdType Slices;
  double Scale[2]; // HeightScale / spacing
  bool FlipGreen;
  int Kernel;
  int Component;
  int Encoding;
  void* Output;

  void Store(vtkIdType texel, const f64::vec3& normal) const
  {
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType place = 3 * texel + c;
      switch (this->Encoding)
      {
        case vtkRelievoHeightsToNormals::UNSIGNED_CHAR:
          static_cast<unsigned char*>(this->Output)[place] =
            static_cast<unsigned char>(f64::relievoQuantizeBiased(normal[c], 255.));
          break;
        case vtkRelievoHeightsToNormals::UNSIGNED_SHORT:
          static_cast<unsigned short*>(this->Output)[place] =
            static_cast<unsigned short>(f64::relievoQuantizeBiased(normal[c], 65535.));
          break;
        default:
          static_cast<float*>(this->Output)[place] = static_cast<float>(normal[c]);
      }
    }
  }

  template <typename ArrayT>
  void operator()(ArrayT* array) const
  {
    const Heights<ArrayT> heights(array, this->Component, this->Kernel);
    const vtkIdType perSlice = this->Columns.Count * this->Rows.Count;
    vtkSMPTools::For(0, this->Rows.Count * this->Slices, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType line = begin; line < end; ++line)
      {
        const vtkIdType slice = line / this->Rows.Count * perSlice;
        const vtkIdType j = line % this->Rows.Count;
        for (vtkIdType i = 0; i < this->Columns.Count; ++i)
        {
          double slope[2] = { heights.SmoothSlope(this->Columns, this->Rows, slice, i, j),
            heights.SmoothSlope(this->Rows, this->Columns, slice, j, i) };
          for (int axis = 0; axis < 2; ++axis)
          {
            slope[axis] = std::isnan(slope[axis]) ? 0. : slope[axis] * this->Scale[axis];
          }
          const double y = this->FlipGreen ? slope[1] : -slope[1];
          this->Store(
            slice + j * this->Columns.Count + i, glm::normalize(f64::vec3(-slope[0], y, 1.)));
        }
      }
    });
  }
};

vtkSmartPointer<vtkDataArray> NewOutput(int encoding)
{
  switch (encoding)
  {
    case vtkRelievoHeightsToNormals::UNSIGNED_CHAR:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    case vtkRelievoHeightsToNormals::UNSIGNED_SHORT:
      return vtkSmartPointer<vtkUnsignedShortArray>::New();
    default:
      return vtkSmartPointer<vtkFloatArray>::New();
  }
}
}

//------------------------------------------------------------------------------
int vtkRelievoHeightsToNormals::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkDataObject::SetPointDataActiveScalarInfo(
    outputs->GetInformationObject(0), NewOutput(this->Encoding)->GetDataType(), 3);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoHeightsToNormals::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // A map that wraps needs its other side.
  return relievo::RequestWholeImage(inputs);
}

//------------------------------------------------------------------------------
int vtkRelievoHeightsToNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  // The pipeline requests an empty image again and again.
  const bool isSaid = this->GetMTime() == this->RefusedAt;
  this->SetErrorCode(vtkErrorCode::NoError);
  output->Initialize();
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkDataArray* heights = this->GetInputArrayToProcess(0, inputs);
  double spacing[3];
  input->GetSpacing(spacing);
  std::string problem;
  if (!heights || heights->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    problem = "the input needs a point array of heights: its scalars, or another that is chosen as "
              "the input array. Its point arrays are: " +
      relievo::ArrayNames(input->GetPointData());
  }
  else if (this->Component >= heights->GetNumberOfComponents())
  {
    problem = "Component is " + std::to_string(this->Component) + ", but the heights have " +
      std::to_string(heights->GetNumberOfComponents()) + " component(s), counted from 0";
  }
  else if (spacing[0] == 0. || spacing[1] == 0.)
  {
    problem = "the image's spacing is 0; set the distance of its columns and rows";
  }
  else if (!std::isfinite(this->HeightScale))
  {
    problem = "HeightScale is not finite";
  }
  if (!problem.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    if (!isSaid)
    {
      vtkErrorMacro("No normals: " << problem << ".");
    }
    this->RefusedAt = this->GetMTime();
    return 1;
  }

  const vtkSmartPointer<vtkDataArray> normals = NewOutput(this->Encoding);
  normals->SetName("normal");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(input->GetNumberOfPoints());
  int size[3];
  input->GetDimensions(size);
  Work work;
  work.Columns = { size[0], 1, this->WrapColumns };
  work.Rows = { size[1], size[0], this->WrapRows };
  work.Slices = size[2];
  work.Scale[0] = this->HeightScale / spacing[0];
  work.Scale[1] = this->HeightScale / spacing[1];
  work.FlipGreen = this->FlipGreen;
  work.Kernel = this->Kernel;
  work.Component = this->Component;
  work.Encoding = this->Encoding;
  work.Output = normals->GetVoidPointer(0);
  if (!vtkArrayDispatch::Dispatch::Execute(heights, work))
  {
    work(heights);
  }
  output->CopyStructure(input);
  output->GetPointData()->SetScalars(normals);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoHeightsToNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
}
