// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRErrors.h
 * @brief Converts every exception of reading or writing to a code and a message.
 */
#ifndef vtkRelievoEXRErrors_h
#define vtkRelievoEXRErrors_h

#include "vtkRelievoEXRFailure.h"

#include <functional>

namespace relievo::exr
{
/**
 * Does the work and returns the failure: code 0 (vtkErrorCode::NoError) on success; code UserError
 * without a message if the user stopped it. Never throws.
 * \param advice  Advice for failures of OpenEXR; ends the message.
 */
Failure Translate(const std::string& advice, const std::function<void()>& work);
}

#endif
