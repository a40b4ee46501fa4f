// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshText.h"

#include "vtkErrorCode.h"
#include "vtkRelievoFileKind.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <cerrno>
#include <cstring>
#include <exception>
#include <new>

namespace relievo
{
//------------------------------------------------------------------------------
std::string LoadMeshText(const char* fileName)
{
  const std::string instead = vtkRelievoFileKind::FindInstead(fileName);
  if (!instead.empty())
  {
    throw Refusal{ vtkErrorCode::CannotOpenFileError, "expected a file, but " + instead };
  }
  errno = 0;
  vtksys::ifstream stream(fileName, std::ios::in | std::ios::binary);
  std::string text(vtksys::SystemTools::FileLength(fileName), '\0');
  if (!stream || !stream.read(text.data(), static_cast<std::streamsize>(text.size())))
  {
    throw Refusal{ errno == ENOENT ? vtkErrorCode::FileNotFoundError
                                   : vtkErrorCode::CannotOpenFileError,
      std::strerror(errno) };
  }
  return text;
}

//------------------------------------------------------------------------------
std::optional<Refusal> FindRefusal(const std::function<void()>& read)
{
  try
  {
    read();
  }
  catch (const Refusal& refusal)
  {
    return refusal;
  }
  catch (const std::bad_alloc&)
  {
    return Refusal{ vtkErrorCode::OutOfDiskSpaceError, "memory ran out" };
  }
  catch (const std::exception& thrown)
  {
    return Refusal{ vtkErrorCode::OutOfDiskSpaceError, thrown.what() };
  }
  return std::nullopt;
}
}
