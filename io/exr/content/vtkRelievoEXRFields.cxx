// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRFields.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkRelievoEXRFailure.h"
#include "vtkSmartPointer.h"

namespace relievo::exr
{
//------------------------------------------------------------------------------
std::vector<double> FieldNumbers(vtkFieldData* fields, const std::string& name, std::size_t n)
{
  vtkAbstractArray* found = fields->GetAbstractArray(name.c_str());
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  if (!found)
  {
    return {};
  }
  if (!array || array->GetNumberOfValues() != static_cast<vtkIdType>(n))
  {
    throw Failure(vtkErrorCode::UserError,
      "the field data array '" + name + "' has " + std::to_string(found->GetNumberOfValues()) +
        (array ? " numbers" : " values") + ", but " + std::to_string(n) +
        " numbers are expected; give that many or remove it");
  }
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.push_back(array->GetComponent(i, c));
    }
  }
  return values;
}

//------------------------------------------------------------------------------
void AddFieldNumbers(
  vtkFieldData* fields, const std::string& name, int vtkType, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkType));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->SetNumberOfTuples(1);
  array->SetTuple(0, values.data());
  fields->AddArray(array);
}

//------------------------------------------------------------------------------
void Insert(Imf::Header& header, const std::string& name, const Imf::Attribute& attribute)
{
  // OpenEXR does not allow changing the type of an attribute that every header has.
  const auto found = header.find(name);
  if (found == header.end() || std::string(found.attribute().typeName()) == attribute.typeName())
  {
    header.insert(name, attribute);
  }
}
}
