// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRFields.h
 * @brief Helpers to convert between field data and EXR headers.
 */
#ifndef vtkRelievoEXRFields_h
#define vtkRelievoEXRFields_h

#include <OpenEXR/ImfAttribute.h>
#include <OpenEXR/ImfHeader.h>

#include <string>
#include <vector>

class vtkFieldData;

namespace relievo::exr
{
/** The numbers of a field array; empty if there is none. Throws Failure unless there are `n`. */
std::vector<double> FieldNumbers(vtkFieldData* fields, const std::string& name, std::size_t n);

/** Adds a field array of one tuple with these values. */
void AddFieldNumbers(
  vtkFieldData* fields, const std::string& name, int vtkType, const std::vector<double>& values);

/** Sets an attribute, unless the header has one of this name with another, fixed type. */
void Insert(Imf::Header& header, const std::string& name, const Imf::Attribute& attribute);

/** The value of an attribute; nullptr unless it exists and is a T. */
template <typename T>
const T* ValueOf(const Imf::Header& header, const std::string& name)
{
  const auto* attribute = header.findTypedAttribute<Imf::TypedAttribute<T>>(name);
  return attribute ? &attribute->value() : nullptr;
}
}

#endif
