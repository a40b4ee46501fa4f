// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPointValues.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRelievoParameter.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
vtkRelievoPointValues::vtkRelievoPointValues()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoPointValues::~vtkRelievoPointValues() = default;

//------------------------------------------------------------------------------
void vtkRelievoPointValues::SetThings(const std::string& things, const std::string& needs)
{
  this->Things = things;
  this->Needs = needs;
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoPointValues::AddPerPoint(
  const vtkRelievoParameter& described, const double* forAll, double first)
{
  const int components = described.GetNumberOfComponents();
  const std::size_t place = this->Values.size();
  this->Values.push_back({ described.Name, components, {}, described.Name });
  std::copy_n(forAll, components, this->Values.back().ForAll);
  this->Width += components;
  vtkRelievoParameter parameter = described;
  parameter.PerPoint = true;
  parameter.GetValues = [this, place, components, first]() {
    std::vector<double> values(this->Values[place].ForAll, this->Values[place].ForAll + components);
    values[0] -= first;
    return values;
  };
  parameter.SetValues = [this, place, first](const std::vector<double>& given) {
    std::vector<double> values = given;
    values[0] += first;
    this->SetForAll(static_cast<int>(place), values.data());
  };
  return this->Description.Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoPointValues::AddValue(const std::string& name, double forAll,
  double least, double most, const std::string& unit, const std::string& help)
{
  vtkRelievoParameter parameter;
  parameter.Name = name;
  parameter.Type = vtkRelievoParameter::NUMBER;
  parameter.Least = least;
  parameter.Most = most;
  parameter.Unit = unit;
  parameter.Help = help;
  return this->AddPerPoint(parameter, &forAll, 0.0);
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::AddColorValue(
  const std::string& name, const double forAll[3], const std::string& help)
{
  vtkRelievoParameter parameter;
  parameter.Name = name;
  parameter.Type = vtkRelievoParameter::COLOR;
  parameter.IsLinear = true;
  parameter.Most = std::numeric_limits<double>::infinity();
  parameter.Help = help;
  this->AddPerPoint(parameter, forAll, 0.0);
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::AddChoiceValue(const std::string& name,
  const std::vector<std::string>& choices, int first, int forAll, const std::string& help)
{
  vtkRelievoParameter parameter;
  parameter.Name = name;
  parameter.Type = vtkRelievoParameter::CHOICE;
  parameter.Most = static_cast<double>(choices.size()) - 1.0;
  parameter.Choices = choices;
  parameter.Help = help;
  const double value = forAll;
  this->AddPerPoint(parameter, &value, first);
}

//------------------------------------------------------------------------------
std::string vtkRelievoPointValues::GetParameter(RELIEVO_TEXT name)
{
  const vtkRelievoParameter* parameter = this->Description.Find(name);
  const Value* value = this->FindValue(name);
  return value && !value->Array.empty() ? value->Array
    : parameter                         ? parameter->Format()
                                        : std::string();
}

//------------------------------------------------------------------------------
bool vtkRelievoPointValues::SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
{
  const std::string message = this->TrySetParameter(name, words);
  if (!message.empty())
  {
    vtkErrorMacro(<< name << ": " << message << ".");
  }
  return message.empty();
}

//------------------------------------------------------------------------------
std::string vtkRelievoPointValues::TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
{
  const vtkRelievoParameter* parameter = this->Description.Find(name);
  if (parameter && !parameter->IsValue(words))
  {
    this->SetArray(name, words);
    return {};
  }
  const std::string message = this->Description.TrySet(name, words);
  if (message.empty() && parameter->PerPoint)
  {
    this->SetArray(name, {});
  }
  return message;
}

//------------------------------------------------------------------------------
bool vtkRelievoPointValues::IsPerPoint(RELIEVO_TEXT name)
{
  return this->FindValue(name) != nullptr;
}

//------------------------------------------------------------------------------
const vtkRelievoPointValues::Value* vtkRelievoPointValues::FindValue(const std::string& name) const
{
  const auto found = std::find_if(this->Values.begin(), this->Values.end(),
    [&name](const Value& value) { return value.Name == name; });
  return found == this->Values.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::SetForAll(int value, const double* forAll)
{
  Value& changed = this->Values[value];
  if (!std::equal(forAll, forAll + changed.Components, changed.ForAll))
  {
    std::copy_n(forAll, changed.Components, changed.ForAll);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::SetInputData(vtkDataObject* data)
{
  this->SetInputDataInternal(0, data);
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::SetArray(RELIEVO_TEXT value, RELIEVO_TEXT array)
{
  std::string names;
  for (Value& known : this->Values)
  {
    if (known.Name == value)
    {
      if (known.Array != array)
      {
        known.Array = array;
        this->Reported.Forget();
        this->Modified();
      }
      return;
    }
    names += (names.empty() ? "" : ", ") + known.Name;
  }
  vtkErrorMacro("There is no value '" << value << "'; expected one of " << names << ".");
}

//------------------------------------------------------------------------------
std::string vtkRelievoPointValues::GetArray(RELIEVO_TEXT value)
{
  const Value* known = this->FindValue(value);
  return known ? known->Array : std::string();
}

//------------------------------------------------------------------------------
int vtkRelievoPointValues::GetNumberOfPoints()
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  else if (!this->Rows.empty())
  {
    this->Rows.clear();
    this->RowsTime.Modified();
  }
  return static_cast<int>(this->Rows.size() / this->Width);
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::SetUserMatrix(vtkMatrix4x4* matrix)
{
  if (this->UserMatrix != matrix)
  {
    this->UserMatrix = matrix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkRelievoPointValues::GetUserMatrix()
{
  return this->UserMatrix;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoPointValues::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->UserMatrix ? std::max(own, this->UserMatrix->GetMTime()) : own;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoPointValues::GetUpdatedTime()
{
  this->GetNumberOfPoints();
  return std::max(this->GetMTime(), this->GetRowsTime());
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::Share(vtkMultiProcessController* controller)
{
  this->GetNumberOfPoints();
  const bool before = this->Shared;
  this->Shared = controller && controller->GetNumberOfProcesses() > 1;
  if (!this->Shared)
  {
    this->All.clear();
    return;
  }
  const int processes = controller->GetNumberOfProcesses();
  const int changed = !before || this->SharedTime != this->RowsTime.GetMTime() ? 1 : 0;
  int anywhere = 0;
  controller->AllReduce(&changed, &anywhere, 1, vtkCommunicator::MAX_OP);
  if (anywhere == 0)
  {
    return;
  }
  this->SharedTime = this->RowsTime.GetMTime();
  const auto own = static_cast<vtkIdType>(this->Rows.size());
  std::vector<vtkIdType> counts(static_cast<std::size_t>(processes));
  controller->AllGather(&own, counts.data(), 1);
  std::vector<vtkIdType> starts(1, 0);
  for (const vtkIdType count : counts)
  {
    starts.push_back(starts.back() + count);
  }
  this->All.resize(static_cast<std::size_t>(starts.back()));
  controller->AllGatherV(this->Rows.data(), this->All.data(), own, counts.data(), starts.data());
}

//------------------------------------------------------------------------------
int vtkRelievoPointValues::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkRelievoPointValues::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  this->Rows.clear();
  this->NumberLeftOut = 0;
  this->RowsTime.Modified();
  if (auto* composite = vtkCompositeDataSet::GetData(inputs[0]))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
      {
        this->Take(leaf);
      }
    }
  }
  else if (vtkDataSet* data = vtkDataSet::GetData(inputs[0]))
  {
    this->Take(data);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::Take(vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  if (count == 0)
  {
    return;
  }
  const std::size_t first = this->Rows.size();
  this->Rows.resize(first + static_cast<std::size_t>(count) * this->Width);
  double* rows = this->Rows.data() + first;
  auto* points = vtkPointSet::SafeDownCast(data);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double* row = rows + i * this->Width;
    points ? points->GetPoints()->GetPoint(i, row) : data->GetPoint(i, row);
    if (this->UserMatrix)
    {
      const double point[4] = { row[0], row[1], row[2], 1.0 };
      double moved[4];
      this->UserMatrix->MultiplyPoint(point, moved);
      std::copy_n(moved, 3, row);
    }
  }
  double* column = rows + 3;
  for (const Value& value : this->Values)
  {
    this->Fill(data, value, column);
    column += value.Components;
  }
  vtkUnsignedCharArray* ghosts = data->GetPointGhostArray();
  constexpr int Elsewhere =
    vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  double* kept = rows;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* row = rows + i * this->Width;
    if (ghosts && (ghosts->GetValue(i) & Elsewhere) != 0)
    {
      continue; // another piece owns the point
    }
    const bool finite =
      std::all_of(row, row + this->Width, [](double v) { return std::isfinite(v); });
    if (!finite || !this->HasColors(row) || !this->HasEffect(row))
    {
      ++this->NumberLeftOut;
      continue;
    }
    if (kept != row)
    {
      std::copy_n(row, this->Width, kept);
    }
    kept += this->Width;
  }
  this->Rows.resize(first + static_cast<std::size_t>(kept - rows));
}

//------------------------------------------------------------------------------
// Whether no component of the row's colours is negative.
bool vtkRelievoPointValues::HasColors(const double* row) const
{
  const double* column = row + 3;
  for (const Value& value : this->Values)
  {
    if (value.Components == 3 && *std::min_element(column, column + 3) < 0.0)
    {
      return false;
    }
    column += value.Components;
  }
  return true;
}

//------------------------------------------------------------------------------
// Fills a column of the rows with one value of all points.
void vtkRelievoPointValues::Fill(vtkDataSet* data, const Value& value, double* column)
{
  const vtkIdType count = data->GetNumberOfPoints();
  vtkDataArray* array =
    value.Array.empty() ? nullptr : data->GetPointData()->GetArray(value.Array.c_str());
  std::string message;
  if (!array && value.Array != value.Name && !value.Array.empty())
  {
    vtkAbstractArray* other = data->GetPointData()->GetAbstractArray(value.Array.c_str());
    message = other ? std::string("holds no numbers (it is a ") + other->GetClassName() + ")"
                    : std::string("is not among the point arrays");
  }
  else if (array)
  {
    const int components = array->GetNumberOfComponents();
    const bool fits = components == value.Components || (value.Components == 3 && components == 4);
    if (!fits)
    {
      message = "has " + std::to_string(components) + " components";
    }
    else if (array->GetNumberOfTuples() != count)
    {
      message = "has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
        std::to_string(count) + " points";
    }
  }
  if (!message.empty())
  {
    const std::string error = "The array '" + value.Array + "', asked for the " + value.Name +
      ", " + message +
      "; needed: " + (value.Components == 3 ? "red, green and blue" : "one number") +
      " per point. One " + value.Name + " is taken for all points.";
    if (this->Reported.IsNew(error))
    {
      vtkErrorMacro(<< error);
    }
    array = nullptr;
  }
  if (!array)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      std::copy_n(value.ForAll, value.Components, column + i * this->Width);
    }
    return;
  }
  // Copied as a block: the virtual interface is slow for many points.
  vtkNew<vtkDoubleArray> numbers;
  numbers->DeepCopy(array);
  const int stride = numbers->GetNumberOfComponents();
  const double* from = numbers->GetPointer(0);
  const bool bytes = value.Components == 3 && array->GetDataType() == VTK_UNSIGNED_CHAR;
  const double scale = bytes ? 1.0 / 255.0 : 1.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int c = 0; c < value.Components; ++c)
    {
      column[i * this->Width + c] = scale * from[i * stride + c];
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPointValues::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Value& value : this->Values)
  {
    os << indent << value.Name << ": array '" << value.Array << "', else";
    for (int c = 0; c < value.Components; ++c)
    {
      os << " " << value.ForAll[c];
    }
    os << "\n";
  }
  os << indent << "NumberLeftOut: " << this->NumberLeftOut << "\n";
}
