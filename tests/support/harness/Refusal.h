// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Refusal.h
 * @brief Checks filters that refuse their input.
 */
#ifndef relievoTestRefusal_h
#define relievoTestRefusal_h

#include "Check.h"
#include "Session.h"

#include <vtkErrorCode.h>

#include <string>

namespace relievoTest
{
/** Updates a filter, which must report `words` once, as a user's error, and give no points. */
template <typename Filter>
void CheckRefused(Filter* filter, const std::string& words)
{
  ExpectMessage expect(words);
  filter->Update();
  RELIEVO_CHECK_THAT(expect.Count() == 1, words);
  RELIEVO_CHECK_THAT(filter->GetErrorCode() == vtkErrorCode::UserError, words);
  RELIEVO_CHECK_THAT(filter->GetOutput()->GetNumberOfPoints() == 0, words);
}
}

#endif
