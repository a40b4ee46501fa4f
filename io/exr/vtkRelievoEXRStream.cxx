// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRStream.h"

#include "vtkErrorCode.h"
#include "vtkRelievoEXRFailure.h"

#include <OpenEXR/Iex.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace relievo::exr
{
namespace
{
int Seek(std::FILE* file, uint64_t position)
{
#ifdef _WIN32
  return _fseeki64(file, static_cast<long long>(position), SEEK_SET);
#else
  return fseeko(file, static_cast<off_t>(position), SEEK_SET);
#endif
}
}

//------------------------------------------------------------------------------
InputStream::InputStream(const std::string& fileName)
  : Imf::IStream(fileName.c_str())
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(fileName, error);
  if (!std::filesystem::exists(status))
  {
    throw Failure(vtkErrorCode::FileNotFoundError, "there is no such file; check the name");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure(
      vtkErrorCode::CannotOpenFileError, "it is a folder; give the name of an .exr file in it");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw Failure(
      vtkErrorCode::CannotOpenFileError, "it is not a regular file; copy its data to one first");
  }
  this->File.reset(std::fopen(fileName.c_str(), "rb"));
  if (!this->File)
  {
    throw Failure(vtkErrorCode::CannotOpenFileError,
      std::string("it cannot be opened: ") + std::strerror(errno) + "; check its permissions");
  }
  this->Size = std::filesystem::file_size(fileName, error);
  if (error)
  {
    throw Failure(vtkErrorCode::CannotOpenFileError, "its size is unknown: " + error.message());
  }
  if (this->Size == 0)
  {
    throw Failure(vtkErrorCode::PrematureEndOfFileError, "the file is empty; write it again");
  }
}

//------------------------------------------------------------------------------
bool InputStream::read(char* to, int count)
{
  const bool enough = count >= 0 && static_cast<uint64_t>(count) <= this->GetRemaining();
  if (!enough || std::fread(to, 1, count, this->File.get()) != static_cast<std::size_t>(count))
  {
    throw Iex::InputExc("Unexpected end of file.");
  }
  this->Position += count;
  return this->Position < this->Size;
}

//------------------------------------------------------------------------------
void InputStream::seekg(uint64_t position)
{
  // Damaged tables of offsets may contain any position.
  if (position > this->Size || Seek(this->File.get(), position) != 0)
  {
    throw Iex::InputExc("Unexpected end of file: an offset leads behind it.");
  }
  this->Position = position;
}

//------------------------------------------------------------------------------
void InputStream::clear()
{
  std::clearerr(this->File.get());
}

//------------------------------------------------------------------------------
OutputStream::OutputStream(const std::string& fileName)
  : Imf::OStream(fileName.c_str())
  , FileName(fileName)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(fileName, error);
  if (std::filesystem::is_directory(status))
  {
    throw Failure(
      vtkErrorCode::CannotOpenFileError, "it is a folder; give the name of a file in it", EISDIR);
  }
  // Renaming onto a device would replace the device.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    throw Failure(vtkErrorCode::CannotOpenFileError,
      "something that is not a regular file has this name; choose another name");
  }
  // Renaming onto a symbolic link would replace the link: write to its target.
  if (std::filesystem::exists(status))
  {
    const std::filesystem::path real = std::filesystem::canonical(fileName, error);
    if (!error)
    {
      this->FileName = real.string();
    }
  }

  this->Temporary = std::make_unique<vtkRelievoTemporaryFile>(
    std::filesystem::path(this->FileName).parent_path().string(), error);
  if (!error)
  {
    this->File.reset(std::fopen(this->Temporary->GetName().c_str(), "r+b"));
    error = this->File ? error : std::error_code(errno, std::generic_category());
  }
  if (error)
  {
    this->Throw(error.value(), "no file can be made in its folder");
  }
  if (std::filesystem::exists(status))
  {
    std::filesystem::permissions(this->Temporary->GetName(), status.permissions(), error);
  }
}

//------------------------------------------------------------------------------
OutputStream::~OutputStream()
{
  this->File.reset(); // closed before it is removed
}

//------------------------------------------------------------------------------
void OutputStream::write(const char* from, int count)
{
  errno = 0;
  if (this->FirstError != 0 ||
    std::fwrite(from, 1, count, this->File.get()) != static_cast<std::size_t>(count))
  {
    this->FirstError = this->FirstError != 0 ? this->FirstError : errno != 0 ? errno : EIO;
    throw Iex::IoExc("Writing failed.");
  }
  this->Position += count;
}

//------------------------------------------------------------------------------
void OutputStream::seekp(uint64_t position)
{
  errno = 0;
  if (Seek(this->File.get(), position) != 0)
  {
    this->FirstError = this->FirstError != 0 ? this->FirstError : errno != 0 ? errno : EIO;
    throw Iex::IoExc("Seeking failed.");
  }
  this->Position = position;
}

//------------------------------------------------------------------------------
void OutputStream::Commit()
{
  errno = 0;
  const bool closed = std::fclose(this->File.release()) == 0;
  if (!closed && this->FirstError == 0)
  {
    this->FirstError = errno != 0 ? errno : EIO;
  }
  this->Check();
  std::error_code error;
  this->Temporary->MoveTo(this->FileName, error);
  if (error)
  {
    this->Throw(error.value(), "the finished file cannot be given its name");
  }
}

//------------------------------------------------------------------------------
void OutputStream::Check() const
{
  if (this->FirstError != 0)
  {
    this->Throw(this->FirstError, "writing failed");
  }
}

//------------------------------------------------------------------------------
void OutputStream::Throw(int error, const char* doing) const
{
  bool full = error == ENOSPC || error == EFBIG;
#ifdef EDQUOT
  full = full || error == EDQUOT;
#endif
  throw Failure(full ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError,
    std::string(doing) + ": " + std::generic_category().message(error) +
      (full ? "; free some space or choose another folder"
            : "; check that the folder exists and may be written to"),
    error);
}
}
