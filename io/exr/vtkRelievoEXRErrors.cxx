// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRErrors.h"

#include "vtkErrorCode.h"

#include <OpenEXR/Iex.h>

#include <new>
#include <stdexcept>

namespace relievo::exr
{
namespace
{
// OpenEXR's messages begin with the name of the file, as ours already do: `Cannot read image file
// "NAME". Unexpected end of file.`
std::string Reason(const std::string& message)
{
  const std::size_t end = message.rfind("\". ");
  std::string reason = end == std::string::npos ? message : message.substr(end + 3);
  while (!reason.empty() && (reason.back() == '.' || reason.back() == '\n'))
  {
    reason.pop_back();
  }
  return reason;
}
}

//------------------------------------------------------------------------------
Failure Translate(const std::string& advice, const std::function<void()>& work)
{
  try
  {
    work();
    return Failure(vtkErrorCode::NoError, "");
  }
  catch (const Failure& failure)
  {
    return failure;
  }
  catch (const Aborted&)
  {
    return Failure(vtkErrorCode::UserError, "");
  }
  catch (const std::bad_alloc&)
  {
    return Failure(vtkErrorCode::UnknownError,
      "there is not enough memory; choose fewer channels or a smaller image");
  }
  catch (const Iex::BaseExc& exception)
  {
    // OpenEXR's threads pass on exceptions of the stream only as text.
    const std::string reason = Reason(exception.what());
    const bool end = reason.find("end of file") != std::string::npos;
    return Failure(end ? vtkErrorCode::PrematureEndOfFileError : vtkErrorCode::FileFormatError,
      "OpenEXR reports: " + reason + "; " + advice);
  }
  catch (const std::length_error&)
  {
    // OpenEXR's message for a negative number of chunks.
    return Failure(vtkErrorCode::FileFormatError, "a size in its header is impossible; " + advice);
  }
  catch (const std::exception& exception)
  {
    return Failure(
      vtkErrorCode::UnknownError, "an exception was thrown: " + Reason(exception.what()));
  }
  catch (...)
  {
    return Failure(vtkErrorCode::UnknownError, "an unknown exception was thrown");
  }
}
}
