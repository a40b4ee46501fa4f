// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clamps a property's values to its range, with a warning: ParaView's domains limit its panel but
// not scripts and state files. The range is that of the property's domain, or a wider one in its
// hints: <Accepts min="0" max="1000"/>, or <Accepts finite="1"/> for any number.
#ifndef vtkSMRelievoRange_h
#define vtkSMRelievoRange_h

#include "vtkPVXMLElement.h"
#include "vtkSMBooleanDomain.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace vtkSMRelievoRange
{
constexpr double Endless = 1e30;

struct Range
{
  double Least = -Endless;
  double Most = Endless;
};

// "0 to 1", "1 or more".
inline std::string Write(const Range& range)
{
  std::ostringstream out;
  const bool open = range.Most >= Endless && range.Least > -Endless;
  open ? out << range.Least << " or more" : out << range.Least << " to " << range.Most;
  return out.str();
}

template <typename RangeDomain>
Range Find(vtkSMProperty* property, unsigned int element)
{
  Range range;
  if (auto* domain = property->FindDomain<RangeDomain>())
  {
    int exists = 0;
    const double least = domain->GetMinimum(element, exists);
    range.Least = exists ? least : range.Least;
    const double most = domain->GetMaximum(element, exists);
    range.Most = exists ? most : range.Most;
  }
  else if (auto* words = property->FindDomain<vtkSMEnumerationDomain>())
  {
    for (unsigned int i = 0; i < words->GetNumberOfEntries(); ++i)
    {
      const double value = words->GetEntryValue(i);
      range.Least = i ? std::min(range.Least, value) : value;
      range.Most = i ? std::max(range.Most, value) : value;
    }
  }
  else if (property->FindDomain<vtkSMBooleanDomain>())
  {
    range = { 0.0, 1.0 };
  }
  return range;
}

// The property's name in scripts.
inline std::string GetName(vtkSMProperty* property)
{
  vtkSMProxy* owner = property->GetParent();
  vtkSMProxy* parent = owner ? owner->GetParentProxy() : nullptr;
  const char* exposed = parent ? parent->GetPropertyName(property) : nullptr;
  return exposed ? exposed : property->GetXMLName();
}

// Called when a property's values are pushed to its object.
template <typename RangeDomain, typename Property>
void Enforce(Property* property)
{
  vtkPVXMLElement* hints = property->GetHints();
  vtkPVXMLElement* accepts = hints ? hints->FindNestedElementByName("Accepts") : nullptr;
  for (unsigned int i = 0; i < property->GetNumberOfElements(); ++i)
  {
    const double given = static_cast<double>(property->GetElement(i));
    Range range = Find<RangeDomain>(property, i);
    if (accepts)
    {
      accepts->GetScalarAttribute("min", &range.Least);
      accepts->GetScalarAttribute("max", &range.Most);
      if (accepts->GetAttribute("finite") && std::isfinite(given))
      {
        continue;
      }
    }
    const double taken =
      given >= range.Least ? (given <= range.Most ? given : range.Most) : range.Least;
    if (taken != given)
    {
      vtkWarningWithObjectMacro(property, << GetName(property) << " was given "
                                          << property->GetElement(i) << ", expected "
                                          << Write(range) << ": " << taken << " is taken.");
      property->SetElement(i, static_cast<decltype(property->GetElement(i))>(taken));
    }
  }
}
}

#endif
