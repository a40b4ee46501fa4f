// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCertificate.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkRelievoShadowCertificate);

namespace
{
// Probability of at most k of n, each with probability p.
double AtMost(long long k, long long n, double p)
{
  double sum = 0.0;
  const double all = static_cast<double>(n);
  // Downwards: below the mean, terms decrease quickly.
  for (long long i = k; i >= 0; --i)
  {
    const double some = static_cast<double>(i);
    const double ways =
      std::lgamma(all + 1.0) - std::lgamma(some + 1.0) - std::lgamma(all - some + 1.0);
    const double term = std::exp(ways + some * std::log(p) + (all - some) * std::log1p(-p));
    sum += term;
    if (some < all * p && term <= 1e-17 * sum)
    {
      break;
    }
  }
  return sum;
}

std::string Percent(double share)
{
  std::ostringstream out;
  out.precision(3);
  out << 100.0 * share << " %";
  return out.str();
}
}

//------------------------------------------------------------------------------
double vtkRelievoShadowCertificate::GetBound(long long wrong, long long judged, double confidence)
{
  if (wrong < 0 || judged < wrong || !(confidence > 0.0 && confidence < 1.0))
  {
    vtkGenericWarningMacro("GetBound was given " << wrong << " wrong of " << judged
                                                 << " and a confidence of " << confidence
                                                 << "; give it counts that are not negative, no "
                                                 << "more wrong than judged, and a confidence "
                                                 << "between 0 and 1.");
    return vtkMath::Nan();
  }
  if (wrong == judged)
  {
    return 1.0;
  }
  // A bound with a confidence below 0.5 is below the share.
  const double some = static_cast<double>(wrong);
  double low = std::max(0.0, some - 40.0 * std::sqrt(some + 1.0)) / static_cast<double>(judged);
  double high = 1.0;
  for (int i = 0; i < 100; ++i)
  {
    const double middle = 0.5 * (low + high);
    (AtMost(wrong, judged, middle) > 1.0 - confidence ? low : high) = middle;
  }
  return high;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowCertificate::GetWrongShare()
{
  return this->Judged > 0
    ? static_cast<double>(this->GetWrong()) / static_cast<double>(this->Judged)
    : vtkMath::Nan();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowCertificate::GetWrongShareBound()
{
  return GetBound(this->GetWrong(), this->Judged);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowCertificate::GetWords()
{
  std::ostringstream out;
  if (this->Judged == 0)
  {
    out << "no verdict could be judged";
  }
  else
  {
    out << this->GetWrong() << " of " << this->Judged << " verdicts are wrong ("
        << this->FalseShadow << " false shadow, " << this->FalseLight
        << " false light): " << Percent(this->GetWrongShare()) << ", at most "
        << Percent(this->GetWrongShareBound()) << " with a confidence of 95 %";
  }
  out << "; counted separately: " << this->Ties << " ties within a pixel's rounding, "
      << this->Grazing << " turned away from the light or grazing, " << this->Unlit
      << " without light to block, " << this->Unknown
      << " involving surfaces that rays cannot trace";
  return out.str();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCertificate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << this->GetWords() << "\n";
}
