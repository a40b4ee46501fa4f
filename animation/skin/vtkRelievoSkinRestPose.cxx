// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinRestPose.h"

#include "vtkRelievoSkinNames.h"
#include "vtkRelievoSkinOrigin.h"
#include "vtkRelievoSkinWeights.h"
#include "vtkRelievoThreads.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoSkinRestPose);

namespace
{
constexpr int Most = vtkRelievoSkinRestPose::MostInfluences;

// The bones of a point, strongest first; in case of a tie, the first one.
struct PointBones
{
  int Joints[Most];
  float Weights[Most];
  int Given = 0; // includes those left out

  int GetCount() const { return std::min(this->Given, Most); }

  PointBones(const relievo::SkinWeights& weights, vtkIdType point, std::size_t bones)
  {
    const int* joints = weights.GetJoints(point);
    const float* shares = weights.GetWeights(point);
    for (int k = 0; k < weights.GetCount(); ++k)
    {
      if (relievo::IsInfluence(joints[k], shares[k], bones))
      {
        this->Add(joints[k], shares[k]);
      }
    }
  }

  void ScaleToOne()
  {
    double sum = 0.;
    for (int k = 0; k < this->GetCount(); ++k)
    {
      sum += this->Weights[k];
    }
    for (int k = 0; k < this->GetCount(); ++k)
    {
      this->Weights[k] = static_cast<float>(this->Weights[k] / sum);
    }
  }

private:
  void Add(int joint, float weight)
  {
    const int kept = this->GetCount();
    int at = kept;
    while (at > 0 && weight > this->Weights[at - 1])
    {
      --at;
    }
    ++this->Given;
    for (int k = std::min(kept, Most - 1); k > at; --k)
    {
      this->Joints[k] = this->Joints[k - 1];
      this->Weights[k] = this->Weights[k - 1];
    }
    if (at < Most)
    {
      this->Joints[at] = joint;
      this->Weights[at] = weight;
    }
  }
};

// Runs `work` on ranges of points with a value per thread, and then passes each value to `take`.
template <typename Value, typename Work, typename Take>
void ForRanges(vtkIdType count, const Work& work, const Take& take)
{
  vtkRelievoWithThreads([&]() {
    vtkSMPThreadLocal<Value> values;
    vtkSMPTools::For(
      0, count, 4096, [&](vtkIdType begin, vtkIdType end) { work(begin, end, values.Local()); });
    for (const Value& each : values)
    {
      take(each);
    }
  });
}

template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, int components, vtkIdType count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}
}

//------------------------------------------------------------------------------
const char* vtkRelievoSkinRestPose::GetJointsName(int four)
{
  return four == 0 ? "relievo_joints_0" : "relievo_joints_1";
}

//------------------------------------------------------------------------------
const char* vtkRelievoSkinRestPose::GetWeightsName(int four)
{
  return four == 0 ? "relievo_weights_0" : "relievo_weights_1";
}

//------------------------------------------------------------------------------
int vtkRelievoSkinRestPose::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkPolyData* about = vtkPolyData::GetData(outputVector, 1);
  output->ShallowCopy(input);
  about->ShallowCopy(input);
  relievo::SkinWeights weights;
  this->Error = input->GetNumberOfPoints() > 0 ? weights.Read(input) : std::string();
  if (input->GetNumberOfPoints() == 0 || !this->Error.empty())
  {
    this->Influences = 0;
    this->PointBounds = relievo::SkinBounds();
    this->Middle = glm::dvec3(0.);
    this->About = nullptr;
    this->Cut = 0;
    this->Times.clear();
    this->Arrays.clear();
    ++this->Version;
    return 1;
  }
  vtkDataArray* nodes = input->GetFieldData()->GetArray(relievo::BoneNodeArray);
  const vtkIdType bones = nodes ? nodes->GetNumberOfTuples() : 0;
  // Other arrays may change with each step of a simulation.
  const std::vector<vtkMTimeType> times = { input->GetPoints()->GetMTime(),
    input->GetPointData()->GetArray(relievo::JointsArray)->GetMTime(),
    input->GetPointData()->GetArray(relievo::WeightsArray)->GetMTime(),
    static_cast<vtkMTimeType>(bones) };
  std::vector<vtkMTimeType> directions;
  for (vtkDataArray* each :
    { input->GetPointData()->GetNormals(), input->GetPointData()->GetTangents() })
  {
    directions.push_back(each ? each->GetMTime() : 0);
  }
  this->Version += times != this->Times || directions != this->Directions ? 1 : 0;
  this->Directions = directions;
  if (times != this->Times)
  {
    this->Prepare(input, weights, static_cast<std::size_t>(bones));
    this->Times = times;
  }
  for (const auto& array : this->Arrays)
  {
    output->GetPointData()->AddArray(array);
  }
  // Cell normals would stay while the faces turn.
  if (vtkDataArray* normals = output->GetCellData()->GetNormals())
  {
    output->GetCellData()->RemoveArray(normals->GetName());
  }
  about->ShallowCopy(output);
  if (this->About)
  {
    about->SetPoints(this->About);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSkinRestPose::Count(
  const relievo::SkinWeights& weights, std::size_t bones, vtkIdType count)
{
  struct Found
  {
    int Most = 0;
    vtkIdType Cut = 0;
  };
  const auto work = [&](vtkIdType begin, vtkIdType end, Found& own) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const int* joints = weights.GetJoints(i);
      const float* shares = weights.GetWeights(i);
      int given = 0;
      for (int k = 0; k < weights.GetCount(); ++k)
      {
        given += relievo::IsInfluence(joints[k], shares[k], bones) ? 1 : 0;
      }
      own.Most = std::max(own.Most, given);
      own.Cut += given > MostInfluences ? 1 : 0;
    }
  };
  // Points stay in place through a bone that does nothing, if the mesh has any bones.
  this->Influences = bones > 0 ? 1 : 0;
  this->Cut = 0;
  ForRanges<Found>(count, work, [this](const Found& own) {
    this->Influences = std::max(this->Influences, std::min<int>(own.Most, MostInfluences));
    this->Cut += own.Cut;
  });
}

//------------------------------------------------------------------------------
void vtkRelievoSkinRestPose::Prepare(
  vtkPolyData* input, const relievo::SkinWeights& weights, std::size_t bones)
{
  const vtkIdType count = input->GetNumberOfPoints();
  this->Count(weights, bones, count);
  this->Arrays.clear();
  this->Middle = relievo::GetFarOrigin(relievo::GetBox(input));
  this->About = nullptr;
  float* abouts = nullptr;
  if (this->Middle != glm::dvec3(0.))
  {
    this->About = vtkSmartPointer<vtkPoints>::New();
    this->About->SetDataType(VTK_FLOAT);
    this->About->SetNumberOfPoints(count);
    abouts = vtkFloatArray::SafeDownCast(this->About->GetData())->GetPointer(0);
  }
  float* places[2] = {};
  float* shares[2] = {};
  for (int four = 0; 4 * four < this->Influences; ++four)
  {
    const auto joints = MakeArray<vtkFloatArray>(GetJointsName(four), 4, count);
    const auto parts = MakeArray<vtkFloatArray>(GetWeightsName(four), 4, count);
    places[four] = joints->GetPointer(0);
    shares[four] = parts->GetPointer(0);
    this->Arrays.insert(this->Arrays.end(), { joints, parts });
  }
  // The CPU must move points identically.
  int* keptJoints = nullptr;
  float* keptWeights = nullptr;
  if (this->Cut > 0)
  {
    const auto joints = MakeArray<vtkIntArray>(relievo::JointsArray, Most, count);
    const auto parts = MakeArray<vtkFloatArray>(relievo::WeightsArray, Most, count);
    keptJoints = joints->GetPointer(0);
    keptWeights = parts->GetPointer(0);
    this->Arrays.insert(this->Arrays.end(), { joints, parts });
  }
  const int width = this->Influences > 4 ? 8 : this->Influences > 0 ? 4 : 0;
  const auto work = [&](vtkIdType begin, vtkIdType end, relievo::SkinBounds& own) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      PointBones point(weights, i, bones);
      point.ScaleToOne();
      const int kept = point.GetCount();
      // Repeats the strongest bone, so that no unrelated matrix has an influence.
      for (int k = kept; k < Most; ++k)
      {
        point.Joints[k] = kept > 0 ? point.Joints[0] : 0;
        point.Weights[k] = 0.f;
      }
      for (int k = 0; k < width; ++k)
      {
        places[k / 4][4 * i + k % 4] = static_cast<float>(point.Joints[k]);
        shares[k / 4][4 * i + k % 4] = point.Weights[k];
      }
      if (keptJoints)
      {
        std::copy_n(point.Joints, Most, keptJoints + Most * i);
        std::copy_n(point.Weights, Most, keptWeights + Most * i);
      }
      double p[3];
      input->GetPoint(i, p);
      const glm::dvec3 at = glm::dvec3(p[0], p[1], p[2]) - this->Middle;
      own.Add(at, point.Joints, point.Weights, kept);
      for (int axis = 0; axis < 3 && abouts; ++axis)
      {
        abouts[3 * i + axis] = static_cast<float>(at[axis]);
      }
    }
  };
  this->PointBounds = relievo::SkinBounds();
  ForRanges<relievo::SkinBounds>(
    count, work, [this](const relievo::SkinBounds& own) { this->PointBounds.Add(own); });
}
