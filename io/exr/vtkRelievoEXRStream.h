// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRStream.h
 * @brief OpenEXR's file streams: the input knows its size, the output appears only when it is
 * complete.
 */
#ifndef vtkRelievoEXRStream_h
#define vtkRelievoEXRStream_h

#include "vtkRelievoTemporaryFile.h"

#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace relievo::exr
{
struct CloseFile
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePointer = std::unique_ptr<std::FILE, CloseFile>;

/**
 * A file to read. Reading or seeking past its end throws Iex::InputExc, "Unexpected end of file".
 */
class InputStream : public Imf::IStream
{
public:
  /** Opens the file; throws Failure if it is missing, a folder, empty or unreadable. */
  explicit InputStream(const std::string& fileName);

  bool read(char* to, int count) override;
  uint64_t tellg() override { return this->Position; }
  void seekg(uint64_t position) override;
  void clear() override;

  uint64_t GetSize() const { return this->Size; }
  uint64_t GetRemaining() const
  {
    return this->Position < this->Size ? this->Size - this->Position : 0;
  }

private:
  FilePointer File;
  uint64_t Size = 0;
  uint64_t Position = 0;
};

/**
 * A file to write. It is written under another name in the same folder; Commit() renames it in one
 * step. Without Commit(), for whatever reason, the destructor removes it, and a previous file
 * remains unchanged.
 */
class OutputStream : public Imf::OStream
{
public:
  /** Makes the file; throws Failure if the folder is missing or not writable. */
  explicit OutputStream(const std::string& fileName);
  ~OutputStream() override;

  void write(const char* from, int count) override;
  uint64_t tellp() override { return this->Position; }
  void seekp(uint64_t position) override;

  /**
   * Closes and renames the file; throws Failure if any write failed, including those whose
   * exception OpenEXR swallows (it writes its table of offsets in a destructor).
   */
  void Commit();

  /** Throws the Failure of the first failed write, if any. */
  void Check() const;

private:
  std::string FileName;
  std::unique_ptr<vtkRelievoTemporaryFile> Temporary;
  FilePointer File;
  uint64_t Position = 0;
  int FirstError = 0; // errno

  [[noreturn]] void Throw(int error, const char* doing) const;
};
}

#endif
