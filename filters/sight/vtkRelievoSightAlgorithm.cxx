// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSightAlgorithm.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoShare.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
// Whether two data sets share their points and cells, whatever their arrays.
bool IsSameGeometry(vtkDataObject* first, vtkDataSet* second)
{
  vtkPolyData* a = vtkPolyData::SafeDownCast(first);
  vtkPolyData* b = vtkPolyData::SafeDownCast(second);
  const auto isSame = [](vtkCellArray* of, vtkCellArray* than) {
    return of == than || (of && than && of->GetNumberOfCells() + than->GetNumberOfCells() == 0);
  };
  return first == second ||
    (a && b && a->GetPoints() == b->GetPoints() && isSame(a->GetVerts(), b->GetVerts()) &&
      isSame(a->GetLines(), b->GetLines()) && isSame(a->GetPolys(), b->GetPolys()) &&
      isSame(a->GetStrips(), b->GetStrips()));
}
}

//------------------------------------------------------------------------------
vtkRelievoSightAlgorithm::vtkRelievoSightAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkRelievoSightAlgorithm::~vtkRelievoSightAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkRelievoSightAlgorithm::SetScene(vtkRelievoRayScene* scene)
{
  if (scene != this->Scene)
  {
    this->Scene = scene;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRelievoRayScene* vtkRelievoSightAlgorithm::GetScene()
{
  return this->Scene;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoSightAlgorithm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Scene ? std::max(own, this->Scene->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkRelievoSightAlgorithm::SetPart(int part, int parts)
{
  if (parts < 1 || part < 1 || part > parts)
  {
    vtkErrorMacro("SetPart: got " << part << " of " << parts
                                  << ", expected a part from 1 to the number of parts.");
    return;
  }
  if (part != this->Part || parts != this->NumberOfParts)
  {
    this->Part = part;
    this->NumberOfParts = parts;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::array<std::size_t, 2> vtkRelievoSightAlgorithm::GetShare(std::size_t all) const
{
  const auto share =
    vtkRelievoShare(this->Part, this->NumberOfParts, static_cast<std::int64_t>(all));
  return { static_cast<std::size_t>(share[0]), static_cast<std::size_t>(share[1]) };
}

//------------------------------------------------------------------------------
int vtkRelievoSightAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoRayScene> vtkRelievoSightAlgorithm::MakeScene(
  vtkInformationVector** inputs)
{
  std::vector<vtkDataSet*> meshes = { vtkPolyData::GetData(inputs[0]) };
  for (int i = 0; i < inputs[1]->GetNumberOfInformationObjects(); ++i)
  {
    meshes.push_back(vtkDataSet::GetData(inputs[1], i));
  }
  vtkSmartPointer<vtkRelievoRayScene> scene = this->Scene;
  if (!scene)
  {
    scene = vtkSmartPointer<vtkRelievoRayScene>::New();
    for (vtkDataSet* mesh : meshes)
    {
      scene->AddData(mesh);
    }
  }
  bool isTheirs = !this->Scene || scene->GetNumberOfProps() == static_cast<int>(meshes.size());
  for (std::size_t i = 0; i < meshes.size() && this->Scene && isTheirs; ++i)
  {
    isTheirs = IsSameGeometry(scene->GetPropData(static_cast<int>(i)), meshes[i]);
  }
  if (!isTheirs)
  {
    vtkErrorMacro("The scene for the rays has other data, expected the mesh and its "
      << meshes.size() - 1 << " occluders in their order.");
    return nullptr;
  }
  scene->SetMinimumDistance(0.0); // not those of the last query
  scene->SetMaximumDistance(vtkMath::Inf());
  scene->Update();
  const std::string fault = scene->GetFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return nullptr;
  }
  return scene;
}

//------------------------------------------------------------------------------
void vtkRelievoSightAlgorithm::AddField(vtkPolyData* mesh, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  mesh->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
void vtkRelievoSightAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Part: " << this->Part << " of " << this->NumberOfParts << "\n";
}
