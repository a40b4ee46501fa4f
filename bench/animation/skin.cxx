// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Models with bones: volume of a twisting or bending tube, and time for a million points; and
// SkinKeys.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "Rounds.h"
#include "SkinFrames.h"
#include "SkinKeys.h"
#include "SkinPeer.h"
#include "Table.h"
#include "vtkRelievoFormulas.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoSkin.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
namespace f64 = relievo::f64;
constexpr double Pi = 3.14159265358979323846;

const char* const Methods[] = { "linear", "dual quaternion" };

void AddMatrices(const char* name, const std::vector<glm::dmat4>& matrices, vtkFieldData* to)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(16);
  for (const glm::dmat4& m : matrices)
  {
    for (int i = 0; i < 16; ++i)
    {
      array->InsertNextValue(m[i % 4][i / 4]);
    }
  }
  to->AddArray(array);
}

vtkSmartPointer<vtkPolyData> Skeleton(const std::vector<glm::dmat4>& pose)
{
  auto skeleton = vtkSmartPointer<vtkPolyData>::New();
  AddMatrices("pose", pose, skeleton->GetPointData());
  return skeleton;
}

// Adds `count` bones to points, with no effect at rest.
void SetBones(vtkPolyData* mesh, int count, int weights,
  const std::function<void(vtkIdType, int*, float*)>& fill)
{
  vtkNew<vtkIntArray> nodes;
  nodes->SetName("bone_node");
  for (int i = 0; i < count; ++i)
  {
    nodes->InsertNextValue(i);
  }
  mesh->GetFieldData()->AddArray(nodes);
  AddMatrices("bone_offset",
    std::vector<glm::dmat4>(static_cast<std::size_t>(count), glm::dmat4(1.)), mesh->GetFieldData());
  vtkNew<vtkIntArray> joints;
  joints->SetName("joints");
  joints->SetNumberOfComponents(weights);
  joints->SetNumberOfTuples(mesh->GetNumberOfPoints());
  vtkNew<vtkFloatArray> shares;
  shares->SetName("weights");
  shares->SetNumberOfComponents(weights);
  shares->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    fill(i, joints->GetPointer(weights * i), shares->GetPointer(weights * i));
  }
  mesh->GetPointData()->AddArray(joints);
  mesh->GetPointData()->AddArray(shares);
}

constexpr int Rings = 81, Sides = 48;

// A tube of radius 1 around x from -4 to 4; the middle half is between the bones.
vtkSmartPointer<vtkPolyData> MakeTube()
{
  auto tube = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (int i = 0; i < Rings * Sides; ++i)
  {
    const double angle = 2. * Pi * (i % Sides) / Sides;
    points->InsertNextPoint(
      -4. + 8. * (i / Sides) / (Rings - 1.), std::cos(angle), std::sin(angle));
  }
  tube->SetPoints(points);
  SetBones(tube, 2, 2, [&](vtkIdType i, int* joints, float* weights) {
    const double x = points->GetPoint(i)[0];
    joints[0] = 0;
    joints[1] = 1;
    weights[1] = static_cast<float>(std::clamp((x + 2.) / 4., 0., 1.));
    weights[0] = 1.f - weights[1];
  });
  return tube;
}

// Computed by the divergence theorem, with a fan at each end.
double VolumeOf(vtkPolyData* tube)
{
  const auto at = [tube](int ring, int side) {
    double p[3];
    tube->GetPoint(ring * Sides + side % Sides, p);
    return glm::dvec3(p[0], p[1], p[2]);
  };
  const auto triangle = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b, c)) / 6.;
  };
  double sum = 0.;
  for (int side = 0; side < Sides; ++side)
  {
    for (int ring = 1; ring < Rings; ++ring)
    {
      sum += triangle(at(ring - 1, side), at(ring, side), at(ring, side + 1));
      sum += triangle(at(ring - 1, side), at(ring, side + 1), at(ring - 1, side + 1));
    }
    sum += triangle(at(0, 0), at(0, side), at(0, side + 1));
    sum -= triangle(at(Rings - 1, 0), at(Rings - 1, side), at(Rings - 1, side + 1));
  }
  return std::abs(sum);
}

bool MeasureVolume(const std::string& outDir)
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTube();
  const double whole = VolumeOf(tube);
  Table table({ "motion", "method", "degrees", "volume, % of the rest" });
  const std::pair<const char*, glm::dvec3> motions[] = { { "twist", glm::dvec3(1., 0., 0.) },
    { "bend", glm::dvec3(0., 0., 1.) } };
  for (const auto& [name, axis] : motions)
  {
    for (int method = 0; method < 2; ++method)
    {
      for (int degrees = 0; degrees <= 180; degrees += 15)
      {
        if (axis.z > 0. && degrees > 120)
        {
          continue; // beyond that, the tube's ends intersect
        }
        const glm::dvec4 q = AboutAxis(axis, degrees * Pi / 180.);
        vtkNew<vtkRelievoSkin> skin;
        skin->SetInputData(0, tube);
        skin->SetInputData(
          1, Skeleton({ glm::dmat4(1.), glm::dmat4(f64::relievoQuaternionMatrix(q)) }));
        skin->SetMethod(method);
        skin->Update();
        table.AddRow({ name, Methods[method], std::to_string(degrees),
          Number(100. * VolumeOf(skin->GetOutput()) / whole, 4) });
      }
    }
  }
  return table.WriteCsv(outDir + "/skin-volume.csv");
}

// Random points with normals, four bones each; adjacent points have adjacent bones.
SkinnedPoints MakePoints(int count, int bones)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1.f, 1.f);
  SkinnedPoints made;
  made.Bones = bones;
  for (int i = 0; i < count; ++i)
  {
    const glm::vec3 p(uniform(random), uniform(random), uniform(random));
    const glm::vec3 n = glm::normalize(p);
    made.Points.insert(made.Points.end(), { p.x, p.y, p.z });
    made.Normals.insert(made.Normals.end(), { n.x, n.y, n.z });
    const auto first = static_cast<int>(static_cast<long long>(i) * bones / count);
    for (int j = 0; j < 4; ++j)
    {
      made.Joints.push_back(static_cast<std::uint16_t>((first + j) % bones));
      made.Weights.push_back(0.4f - 0.1f * static_cast<float>(j));
    }
  }
  for (int i = 0; i < bones; ++i)
  {
    const glm::dvec3 axis(uniform(random), uniform(random), 2.);
    const glm::dvec4 q = AboutAxis(glm::normalize(axis), uniform(random));
    for (int j = 0; j < 4; ++j)
    {
      made.Turns.push_back(static_cast<float>(q[j]));
    }
  }
  return made;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const SkinnedPoints& from)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  const auto fill = [](const std::vector<float>& values) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
  };
  vtkNew<vtkPoints> points;
  points->SetData(fill(from.Points));
  mesh->SetPoints(points);
  const auto normals = fill(from.Normals);
  normals->SetName("Normals");
  mesh->GetPointData()->SetNormals(normals);
  SetBones(mesh, from.Bones, 4, [&](vtkIdType i, int* joints, float* weights) {
    for (vtkIdType j = 0; j < 4; ++j)
    {
      joints[j] = from.Joints[static_cast<std::size_t>(4 * i + j)];
      weights[j] = from.Weights[static_cast<std::size_t>(4 * i + j)];
    }
  });
  return mesh;
}

// Milliseconds of an update.
double TimeSkin(vtkPolyData* mesh, vtkPolyData* skeleton, int method)
{
  vtkNew<vtkRelievoSkin> skin;
  skin->SetInputData(0, mesh);
  skin->SetInputData(1, skeleton);
  skin->SetMethod(method);
  const auto begin = std::chrono::steady_clock::now();
  skin->Update();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  return time.count();
}

// Frames of the graphics card: the mesh without movement, and moved by a new pose in each frame.
void MeasureFrames(const SkinSizes& sizes, int bones, Table& table)
{
  const vtkSmartPointer<vtkPolyData> sheet = MakeSheet(sizes.Points);
  const vtkIdType count = sheet->GetNumberOfPoints();
  SetBones(sheet, bones, 4, [&](vtkIdType i, int* joints, float* weights) {
    const auto first = static_cast<int>(i * bones / count);
    for (int j = 0; j < 4; ++j)
    {
      joints[j] = (first + j) % bones;
      weights[j] = 0.4f - 0.1f * static_cast<float>(j);
    }
  });
  // Small turns, so that about as much is visible in all.
  vtkSmartPointer<vtkPolyData> poses[2];
  for (int which = 0; which < 2; ++which)
  {
    std::vector<glm::dmat4> pose;
    for (int i = 0; i < bones; ++i)
    {
      const double angle = 0.05 * std::sin(i + 2. * which);
      pose.emplace_back(f64::relievoQuaternionMatrix(AboutAxis(glm::dvec3(0., 0., 1.), angle)));
    }
    poses[which] = Skeleton(pose);
  }
  const auto times = TimeSkinnedFrames(sheet, poses[0], poses[1], sizes.Rounds);
  const char* const names[] = { "rigid", Methods[0], Methods[1] };
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double million = 1e9 / static_cast<double>(count);
    const double median = times[i][times[i].size() / 2];
    table.AddRow({ std::to_string(bones), "4", "GPU", names[i], std::to_string(count),
      Number(million * median, 3), Number(million * times[i].front(), 3) });
    std::cout << bones << " bones, frame, " << names[i] << ": " << Number(million * median, 3)
              << " ms per million points, " << Number(median / times[0][times[0].size() / 2], 3)
              << " of the rigid frame" << std::endl;
  }
}

bool MeasureTime(const std::string& outDir, const SkinSizes& sizes)
{
  Table table({ "bones", "weights", "on", "method", "points", "ms per million points",
    "fastest, ms per million points" });
  const std::string file = outDir + "/skin-peer.glb";
  for (const int bones : sizes.Bones)
  {
    const SkinnedPoints points = MakePoints(sizes.Points, bones);
    const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(points);
    std::vector<glm::dmat4> pose;
    for (std::size_t i = 0; i < points.Turns.size(); i += 4)
    {
      const glm::dvec4 q(
        points.Turns[i], points.Turns[i + 1], points.Turns[i + 2], points.Turns[i + 3]);
      pose.emplace_back(f64::relievoQuaternionMatrix(glm::normalize(q)));
    }
    const vtkSmartPointer<vtkPolyData> skeleton = Skeleton(pose);
    WriteSkinned(file, points);
    // Methods in turn, so that other work on the machine affects all of them.
    std::vector<double> times[3];
    for (int round = 0; round < GetRounds(sizes.Rounds); ++round)
    {
      for (int method = 0; method < 2; ++method)
      {
        times[method].push_back(TimeSkin(mesh, skeleton, method));
      }
    }
    times[2] = TimeVtkReader(file, std::max(1, GetRounds(sizes.Rounds) / 3));
    if (times[2].empty())
    {
      std::cerr << "VTK's reader sees no animation in " << file << std::endl;
      return false;
    }
    const char* const names[] = { Methods[0], Methods[1], "VTK's glTF reader" };
    for (int i = 0; i < 3; ++i)
    {
      std::sort(times[i].begin(), times[i].end());
      const double million = 1e6 / sizes.Points;
      const double median = million * times[i][times[i].size() / 2];
      table.AddRow({ std::to_string(bones), "4", "CPU", names[i], std::to_string(sizes.Points),
        Number(median, 3), Number(million * times[i].front(), 3) });
      std::cout << bones << " bones, " << names[i] << ": " << Number(median, 3)
                << " ms per million points" << std::endl;
    }
    MeasureFrames(sizes, bones, table);
  }
  std::remove(file.c_str());
  return table.WriteCsv(outDir + "/skin.csv");
}
}

namespace relievoBench
{
//------------------------------------------------------------------------------
int BenchSkin(const std::string& outDir, const SkinSizes& sizes)
{
  const bool written = MakeFolder(outDir) && MeasureSkinKeys(outDir) && MeasureVolume(outDir) &&
    MeasureTime(outDir, sizes);
  return written ? 0 : 1;
}
}

//------------------------------------------------------------------------------
int RelievoBenchSkin(const std::string& outDir)
{
  return relievoBench::BenchSkin(outDir, {});
}
