// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSightAlgorithm.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkRelievoRayScene.h"

//------------------------------------------------------------------------------
vtkRelievoSightAlgorithm::vtkRelievoSightAlgorithm()
{
  this->SetNumberOfInputPorts(2);
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
  auto scene = vtkSmartPointer<vtkRelievoRayScene>::New();
  scene->AddData(vtkPolyData::GetData(inputs[0]));
  for (int i = 0; i < inputs[1]->GetNumberOfInformationObjects(); ++i)
  {
    scene->AddData(vtkDataSet::GetData(inputs[1], i));
  }
  return scene;
}
