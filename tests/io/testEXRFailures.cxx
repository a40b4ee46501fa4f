// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that cannot be read, places that cannot be written: one clear message, nothing left over.
#include "ForeignFiles.h"
#include "ImageTools.h"

#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoEXRWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <OpenEXR/ImfChannelList.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>

namespace testEXRFailures
{
using Imath::Box2i;
using Imath::V2i;

namespace
{
const Box2i Window(V2i(0, 0), V2i(44, 36));

std::string Folder()
{
  return relievoTest::OutputFolder() + "/files";
}

std::string File()
{
  return Folder() + "/picture.exr";
}

// Reads the file, which must fail with one message that names it and holds these words.
void CheckRefused(const std::string& file, const std::string& words, unsigned long code)
{
  const std::string what = words + " of " + file + ": ";
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(file.c_str());
  {
    relievoTest::ExpectMessage expect(words);
    reader->Update();
    reader->Update(); // it has been said
    RELIEVO_CHECK_THAT(expect.Count() == 1, what + std::to_string(expect.Count()) + " messages");
    const std::string message = expect.Count() > 0 ? expect.Messages()[0] : "";
    RELIEVO_CHECK_THAT(message.find("'" + file + "'") != std::string::npos, what + message);
  }
  RELIEVO_CHECK_THAT(reader->GetErrorCode() == code,
    what + vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  RELIEVO_CHECK_THAT(reader->GetOutput()->GetNumberOfPoints() == 0, what + "points");
  RELIEVO_CHECK_THAT(
    reader->GetOutput()->GetPointData()->GetNumberOfArrays() == 0, what + "arrays");
  RELIEVO_CHECK_THAT(
    reader->GetOutput()->GetFieldData()->GetNumberOfArrays() == 0, what + "field data");
}

// Sets the bytes of an attribute's value in the file.
std::string WithAttribute(std::string bytes, const std::string& name, const std::string& value)
{
  const std::size_t start = bytes.find(name + '\0');
  const std::size_t size = bytes.find('\0', start + name.size() + 1) + 1;
  return bytes.replace(size + 4, value.size(), value);
}

std::string Int(int value)
{
  return std::string(reinterpret_cast<const char*>(&value), 4);
}

void TestFilesThatAreNone()
{
  CheckRefused(Folder() + "/missing.exr", "there is no such file", vtkErrorCode::FileNotFoundError);
  CheckRefused(Folder(), "it is a folder", vtkErrorCode::CannotOpenFileError);
  CheckRefused("", "no file name is given", vtkErrorCode::NoFileNameError);
  CheckRefused("/dev/null", "it is not a regular file", vtkErrorCode::CannotOpenFileError);
  ioTest::WriteBytes(File(), "");
  CheckRefused(File(), "the file is empty", vtkErrorCode::PrematureEndOfFileError);
  ioTest::WriteBytes(File(), "\x76\x2f");
  CheckRefused(File(), "it is not an OpenEXR file", vtkErrorCode::UnrecognizedFileTypeError);
  ioTest::WriteBytes(File(), "\x89PNG\r\n\x1a\n and so on");
  CheckRefused(File(), "it is not an OpenEXR file", vtkErrorCode::UnrecognizedFileTypeError);
  ioTest::WriteBytes(File(), std::string("\x76\x2f\x31\x01\x07\0\0\0", 8));
  CheckRefused(File(), "version 7", vtkErrorCode::UnrecognizedFileTypeError);
}

// Cut anywhere, a file is refused: in its header, its table of offsets or its pixels.
void TestCutFiles()
{
  ioTest::WriteScanLines(File(), ioTest::MakeHeader(Window, Window, { "depth.Z", "R" }));
  const std::string whole = ioTest::Bytes(File());
  const std::string cut = Folder() + "/cut.exr";
  for (std::size_t size = 8; size < whole.size(); size += size < 400 ? 13 : 97)
  {
    ioTest::WriteBytes(cut, whole.substr(0, size));
    CheckRefused(cut, "write or fetch it again", vtkErrorCode::PrematureEndOfFileError);
  }
  // A writer that died before it wrote the table of offsets at the end.
  std::string died = whole;
  const std::size_t chunks = 3; // 37 lines, 16 at once
  uint64_t first = 0;
  for (std::size_t at = 8; at + 8 * chunks < whole.size() && first == 0; ++at)
  {
    std::memcpy(&first, &whole[at], 8);
    first = first == at + 8 * chunks ? first : 0;
    if (first != 0)
    {
      std::memset(&died[at], 0, 8 * chunks);
    }
  }
  RELIEVO_CHECK(first != 0);
  ioTest::WriteBytes(cut, died);
  CheckRefused(cut, "missing", vtkErrorCode::FileFormatError);
}

// A header may promise anything; memory is not given before it is believed.
void TestHugeHeaders()
{
  ioTest::WriteScanLines(File(), ioTest::MakeHeader(Window, Window, { "depth.Z" }));
  const std::string good = ioTest::Bytes(File());
  ioTest::WriteTiles(File(), ioTest::MakeHeader(Window, Window, { "Z" }), 16, 16, Imf::ONE_LEVEL);
  const std::string tiled = ioTest::Bytes(File());
  const std::string bad = Folder() + "/huge.exr";
  const auto check = [&](const std::string& bytes, const char* words, unsigned long code) {
    ioTest::WriteBytes(bad, bytes);
    struct rusage before;
    getrusage(RUSAGE_SELF, &before);
    CheckRefused(bad, words, code);
    struct rusage after;
    getrusage(RUSAGE_SELF, &after);
    RELIEVO_CHECK_AT_MOST(
      (after.ru_maxrss - before.ru_maxrss) / 1024.0, 64, std::string(words) + ", MiB more");
  };
  const int most = 1073741822; // the largest coordinate that OpenEXR allows
  const std::string corner = Int(0) + Int(0);
  check(WithAttribute(good, "dataWindow", corner + Int(2147483647) + Int(2147483647)),
    "Invalid data window", vtkErrorCode::FileFormatError);
  check(WithAttribute(good, "dataWindow", corner + Int(most) + Int(most)), "end of file",
    vtkErrorCode::PrematureEndOfFileError);
  check(WithAttribute(good, "dataWindow", Int(-most) + Int(0) + Int(most) + Int(36)),
    "2147483645 x 37 pixels, more than can be packed", vtkErrorCode::PrematureEndOfFileError);
  check(WithAttribute(good, "dataWindow", corner + Int(100000) + Int(36)),
    "100001 x 37 pixels, more than can be packed", vtkErrorCode::PrematureEndOfFileError);
  check(WithAttribute(good, "dataWindow", Int(5) + Int(0) + Int(4) + Int(0)), "Invalid data window",
    vtkErrorCode::FileFormatError);
  check(WithAttribute(tiled, "tiles", Int(2147483647) + Int(2147483647)), "more than can be packed",
    vtkErrorCode::PrematureEndOfFileError);
  check(WithAttribute(tiled, "tiles", Int(1) + Int(100000000)), "more than can be packed",
    vtkErrorCode::PrematureEndOfFileError);
  // An attribute of 2 GiB, and one whose size is not its type's.
  std::string bytes = good;
  const std::size_t size = bytes.find("lineOrder", bytes.find("lineOrder") + 9) + 10;
  check(bytes.replace(size, 4, Int(2147483647)), "attribute 'lineOrder' claims 2147483647 bytes",
    vtkErrorCode::PrematureEndOfFileError);
  check(bytes.replace(size, 4, Int(3)), "attribute 'lineOrder' has 3 bytes, but lineOrder has 1",
    vtkErrorCode::FileFormatError);
  // More channels than anybody has.
  std::vector<std::string> names(5000);
  for (std::string& name : names)
  {
    name = "c" + std::to_string(&name - names.data());
  }
  const Box2i pixel(V2i(0, 0), V2i(0, 0));
  ioTest::WriteScanLines(File(), ioTest::MakeHeader(pixel, pixel, names, Imf::HALF));
  check(ioTest::Bytes(File()), "more than 4096 channels", vtkErrorCode::FileFormatError);
}

void CheckNotWritten(
  vtkRelievoEXRWriter* writer, const std::string& words, unsigned long code, int count = 1)
{
  relievoTest::ExpectMessage expect(words);
  RELIEVO_CHECK_THAT(writer->Write() == 0, words + ": was written");
  RELIEVO_CHECK_THAT(
    expect.Count() == count, words + ": " + std::to_string(expect.Count()) + " messages");
  RELIEVO_CHECK_THAT(writer->GetErrorCode() == code,
    words + ": " + vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
}

void TestPlacesThatCannotBeWritten()
{
  auto image = ioTest::MakeLayers(20, 20);
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  CheckNotWritten(writer, "no file name is given", vtkErrorCode::NoFileNameError);
  writer->SetFileName((Folder() + "/none/x.exr").c_str());
  CheckNotWritten(writer, "no file can be made in its folder", vtkErrorCode::CannotOpenFileError);
  writer->SetFileName(Folder().c_str());
  CheckNotWritten(writer, "it is a folder", vtkErrorCode::CannotOpenFileError);
  writer->SetFileName("/dev/null");
  CheckNotWritten(writer, "not a regular file", vtkErrorCode::CannotOpenFileError);
  writer->SetFileName("/proc/x.exr"); // a folder where not even root can make files
  CheckNotWritten(writer, "no file can be made in its folder", vtkErrorCode::CannotOpenFileError);
  vtkNew<vtkRelievoEXRWriter> empty;
  empty->SetFileName(File().c_str());
  CheckNotWritten(empty, "there is no image", vtkErrorCode::UserError);
}

// A refused part ends the picture, and leaves nothing behind.
void TestRows()
{
  auto image = ioTest::MakeLayers(20, 20);
  const auto check = [&](const char* words, vtkImageData* second, const char* name, int height) {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetFileName(File().c_str());
    RELIEVO_CHECK(writer->WriteRows(image, 10, 10, 20) == 1);
    RELIEVO_CHECK(ioTest::Listing(Folder()) != "");
    writer->SetFileName(name);
    relievoTest::ExpectMessage expect(words);
    RELIEVO_CHECK_THAT(writer->WriteRows(second, 0, 10, height) == 0, words);
    RELIEVO_CHECK_THAT(expect.Count() == 1, words);
    RELIEVO_CHECK_THAT(writer->GetErrorCode() == vtkErrorCode::UserError, words);
    RELIEVO_CHECK_THAT(ioTest::Listing(Folder()) == "", words);
  };
  check("no image", nullptr, File().c_str(), 20);
  check("rows that the image", ioTest::MakeLayers(20, 9), File().c_str(), 20);
  check("another height or file name", image, File().c_str(), 21);
  check("another height or file name", image, (Folder() + "/other.exr").c_str(), 20);
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetFileName(File().c_str());
  RELIEVO_CHECK(writer->WriteRows(image, 10, 10, 20) == 1);
  RELIEVO_CHECK(writer->WriteRows(image, 0, 10, 20) == 1);
  RELIEVO_CHECK(ioTest::Difference(image, ioTest::Read(File())).empty());
}

// The disk is full after some bytes: a limit of this process stands for it.
void TestFullDisk()
{
  auto image = ioTest::MakeLayers(100, 100);
  auto described = vtkSmartPointer<vtkImageData>::New(); // with a header longer than C's buffers
  described->ShallowCopy(image);
  vtkNew<vtkStringArray> record;
  record->SetName("record");
  record->InsertNextValue(std::string(20000, 'r'));
  described->GetFieldData()->AddArray(record);
  ioTest::WriteBytes(File(), "what was there before");
  std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  for (const rlim_t limit : { 0, 100, 8192, 70000 })
  {
    struct rlimit small = before;
    small.rlim_cur = limit;
    setrlimit(RLIMIT_FSIZE, &small);
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(limit == 0 ? described : image);
    writer->SetFileName(File().c_str());
    {
      relievoTest::ExpectMessage expect("writing failed: File too large");
      RELIEVO_CHECK(writer->Write() == 0);
      setrlimit(RLIMIT_FSIZE, &before); // before anything else is printed to a file
      RELIEVO_CHECK(expect.Count() == 1);
    }
    RELIEVO_CHECK(writer->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError);
    RELIEVO_CHECK(ioTest::Bytes(File()) == "what was there before");
    RELIEVO_CHECK_THAT(
      ioTest::Listing(Folder()) == "picture.exr", "left over: " + ioTest::Listing(Folder()));
  }
  std::signal(SIGXFSZ, SIG_DFL);
}

void TestImagesThatDoNotFit()
{
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetFileName(File().c_str());
  const auto check = [&](vtkImageData* image, const char* words) {
    writer->SetInputData(image);
    CheckNotWritten(writer, words, vtkErrorCode::UserError);
  };
  const auto one = [](int, int) { return 1; };
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(2, 2, 2);
  ioTest::AddArray(volume, "depth", VTK_FLOAT, 1, one);
  check(volume, "2 x 2 x 2 points");
  check(ioTest::MakeImage(2, 2), "no point arrays");

  auto image = ioTest::MakeImage(2, 2);
  ioTest::AddArray(image, "cell", VTK_ID_TYPE, 1, [](int i, int) { return i * 3e9; });
  check(image, "the array 'cell' holds 6000000000, which UINT cannot hold");
  ioTest::AddArray(image, "cell", VTK_INT, 1, [](int i, int) { return 16777216 + i; });
  writer->SetPixelType("cell", vtkRelievoEXRWriter::FLOAT);
  check(image, "the array 'cell' holds 16777219, which FLOAT cannot hold exactly");
  writer->RemoveAllPixelTypes();
  writer->SetPixelType("depht", vtkRelievoEXRWriter::HALF);
  check(image, "'depht', but the image has no such array or channel; it has the arrays cell");
  writer->RemoveAllPixelTypes();
  ioTest::AddArray(image, "depth", VTK_FLOAT, 1, one);
  writer->SetPixelType("depth", vtkRelievoEXRWriter::UINT);
  check(image, "the array 'depth' holds float values, which UINT cannot");
  writer->RemoveAllPixelTypes();
  ioTest::AddArray(image, std::string(254, 'n'), VTK_FLOAT, 1, one);
  check(image, "is too long");
  image->GetPointData()->RemoveArray(2);
  ioTest::AddArray(image, "", VTK_FLOAT, 1, one);
  check(image, "point array 2 has no name");
  image->GetPointData()->RemoveArray(2);
  ioTest::AddField(image, "near", { 1, 2 });
  check(image, "'near' has 2 numbers, but 1 numbers are expected");
  image->GetFieldData()->RemoveArray("near");
  vtkNew<vtkStringArray> strings;
  strings->SetName("words");
  strings->SetNumberOfValues(4);
  image->GetPointData()->AddArray(strings);
  check(image, "the array 'words' is of type string");
  RELIEVO_CHECK(ioTest::Bytes(File()) == "what was there before");
}

void TestSettings()
{
  vtkNew<vtkRelievoEXRWriter> writer;
  const auto check = [](const char* words, const std::function<void()>& set) {
    relievoTest::ExpectMessage expect(words);
    set();
    RELIEVO_CHECK(expect.Count() == 1);
  };
  check("'zap' is none of none, rle", [&] { writer->SetCompressionByName("zap"); });
  check("10 is none of the compressions", [&] { writer->SetCompression(10); });
  check("the type 3 is given", [&] { writer->SetPixelType("depth", 3); });
  for (const char* name : { "", "dataWindow", "near", "relievo:arrays", "pixelAspectRatio" })
  {
    check("An attribute cannot be named", [&] { writer->SetDoubleAttribute(name, 1); });
    check("An attribute cannot be named", [&] { writer->SetStringAttribute(name, ""); });
  }
  RELIEVO_CHECK(writer->GetCompression() == vtkRelievoEXRWriter::ZIP);
}

// Stopped from a progress observer, both end without a word and leave nothing behind.
void TestAbort()
{
  auto image = ioTest::MakeImage(2000, 3000); // more than is written or read at once
  ioTest::AddArray(image, "depth", VTK_FLOAT, 1, [](int i, int) { return i; });
  RELIEVO_CHECK(ioTest::Write(image, File()));
  const std::string before = ioTest::Bytes(File());

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    auto* algorithm = static_cast<vtkAlgorithm*>(caller);
    algorithm->SetAbortExecute(algorithm->GetProgress() > 0.0);
  });
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(File().c_str());
  writer->AddObserver(vtkCommand::ProgressEvent, stop);
  RELIEVO_CHECK(writer->Write() == 0);
  RELIEVO_CHECK(writer->GetErrorCode() == vtkErrorCode::UserError);
  RELIEVO_CHECK(ioTest::Bytes(File()) == before);
  RELIEVO_CHECK(ioTest::Listing(Folder()) == "picture.exr");

  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(File().c_str());
  const unsigned long observer = reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  RELIEVO_CHECK(reader->GetErrorCode() == vtkErrorCode::UserError);
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
  // Let go, it reads.
  reader->RemoveObserver(observer);
  reader->SetAbortExecute(0);
  reader->Update();
  RELIEVO_CHECK(reader->GetErrorCode() == 0);
  const std::string difference = ioTest::Difference(image, reader->GetOutput());
  RELIEVO_CHECK_THAT(difference.empty(), difference);
}

// A new file replaces an old one, keeps its permissions, and goes where a link leads.
void TestReplacing()
{
  auto image = ioTest::MakeLayers(3, 3);
  chmod(File().c_str(), 0640);
  std::filesystem::create_symlink("picture.exr", Folder() + "/link.exr");
  RELIEVO_CHECK(ioTest::Write(image, Folder() + "/link.exr"));
  RELIEVO_CHECK(std::filesystem::is_symlink(Folder() + "/link.exr"));
  RELIEVO_CHECK(ioTest::Difference(image, ioTest::Read(File())).empty());
  struct stat status;
  RELIEVO_CHECK(stat(File().c_str(), &status) == 0 && (status.st_mode & 0777) == 0640);
  RELIEVO_CHECK(ioTest::Listing(Folder()) == "link.exr picture.exr");
}
}

RELIEVO_TEST_CASE_APART(testEXRFailures)
{
  relievoTest::Session session;
  std::filesystem::remove_all(Folder());
  std::filesystem::create_directories(Folder());
  TestFilesThatAreNone();
  TestCutFiles();
  TestHugeHeaders();
  std::filesystem::remove_all(Folder());
  std::filesystem::create_directories(Folder());
  TestPlacesThatCannotBeWritten();
  TestRows();
  TestFullDisk();
  TestImagesThatDoNotFit();
  TestSettings();
  TestAbort();
  TestReplacing();
  return session.Result();
}
}
