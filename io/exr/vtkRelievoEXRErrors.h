// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRErrors.h
 * @brief Where exceptions end: whatever reading or writing throws becomes a code and a message.
 */
#ifndef vtkRelievoEXRErrors_h
#define vtkRelievoEXRErrors_h

#include "vtkRelievoEXRFailure.h"

#include <functional>

namespace relievo::exr
{
/**
 * Does the work and returns how it failed: code 0 (vtkErrorCode::NoError) when it did not, the code
 * UserError and no message when the user stopped it. Never throws.
 * \param advice  What to do when OpenEXR has failed; ends the message.
 */
Failure Translate(const std::string& advice, const std::function<void()>& work);
}

#endif
