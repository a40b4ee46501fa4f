// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Prepares a mesh with bones for the vertex shader: its joints and weights as arrays of four
 * components, strongest first, with sum 1, without missing joints. Where points lose influences,
 * `joints` and `weights` lose them too. Port 1 has these with points relative to GetMiddle(), for
 * the floats of the graphics card.
 */
#ifndef vtkRelievoSkinRestPose_h
#define vtkRelievoSkinRestPose_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoSkinBounds.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkDataArray;
class vtkPoints;

namespace relievo
{
class SkinWeights;
}

class vtkRelievoSkinRestPose : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoSkinRestPose* New();
  vtkTypeMacro(vtkRelievoSkinRestPose, vtkPolyDataAlgorithm);

  enum : int
  {
    MostInfluences = 8
  };

  static const char* GetJointsName(int four);
  static const char* GetWeightsName(int four);

  int GetInfluences() const { return this->Influences; } ///< most per point; 0: nothing moves
  const std::string& GetError() const { return this->Error; }
  /// For the points relative to GetMiddle().
  const relievo::SkinBounds& GetSkinBounds() const { return this->PointBounds; }
  /// For a mesh far from the origin, otherwise the origin.
  const glm::dvec3& GetMiddle() const { return this->Middle; }
  /// A number above 0 that changes with the data that a pose moves: points, directions, joints,
  /// weights, bones; but not with colours.
  vtkMTimeType GetVersion() const { return this->Version; }
  vtkIdType GetNumberOfCut() const { return this->Cut; } ///< points that lost influences

protected:
  vtkRelievoSkinRestPose() { this->SetNumberOfOutputPorts(2); }
  ~vtkRelievoSkinRestPose() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoSkinRestPose(const vtkRelievoSkinRestPose&) = delete;
  void operator=(const vtkRelievoSkinRestPose&) = delete;

  void Prepare(vtkPolyData* input, const relievo::SkinWeights& weights, std::size_t bones);
  void Count(const relievo::SkinWeights& weights, std::size_t bones, vtkIdType count);

  int Influences = 0;
  std::string Error;
  relievo::SkinBounds PointBounds;
  glm::dvec3 Middle{ 0. };
  vtkSmartPointer<vtkPoints> About; // null if the middle is the origin
  vtkIdType Cut = 0;
  std::vector<vtkMTimeType> Times;      // of the arrays used
  std::vector<vtkMTimeType> Directions; // of normals and tangents
  vtkMTimeType Version = 1;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};

#endif
