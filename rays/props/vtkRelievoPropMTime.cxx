// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPropMTime.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoPropMTime::OfData(vtkDataObject* data)
{
  vtkMTimeType time = data ? data->GetMTime() : 0;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    // Includes nodes with children, whose blocks may be replaced by older ones.
    auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    it->VisitOnlyLeavesOff();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      time = std::max(time, it->GetCurrentDataObject()->GetMTime());
    }
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      time = std::max(time, it->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoPropMTime::OfTexture(vtkTexture* texture)
{
  vtkMTimeType time = texture ? texture->GetMTime() : 0;
  for (int port = 0; texture && port < texture->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < texture->GetNumberOfInputConnections(port); ++i)
    {
      texture->GetInputAlgorithm(port, i)->Update();
      time = std::max(time, OfData(texture->GetInputDataObject(port, i)));
    }
  }
  return time;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoPropMTime::OfInputs(vtkMapper* mapper)
{
  vtkMTimeType time = 0;
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      time = std::max(time, OfData(mapper->GetInputDataObject(port, i)));
    }
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    time = std::max(time, planes->GetMTime());
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      time = std::max(time, plane->GetMTime());
    }
  }
  return time;
}
