// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOFFReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoFileKind.h"
#include "vtkRelievoOFFTokenizer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

vtkStandardNewMacro(vtkRelievoOFFReader);

namespace
{
using relievo::Refusal;
using relievo::off::Words;

constexpr unsigned char DefaultGrey = 170;

// The first word of the file, parsed.
struct Header
{
  bool TextureCoordinates = false;
  bool Colors = false;
  bool Normals = false;
};

// False if the header is not supported.
bool ParseHeader(std::string word, Header& header)
{
  const auto take = [&word](const char* prefix) {
    const std::string text = prefix;
    const bool there = word.compare(0, text.size(), text) == 0;
    word.erase(0, there ? text.size() : 0);
    return there;
  };
  header.TextureCoordinates = take("ST");
  header.Colors = take("C");
  header.Normals = take("N");
  return word == "OFF";
}

// Collects colours; they are fractions of 255 if any number of the list is above 1, otherwise of 1.
class ColorList
{
public:
  // `count` numbers: 3, 4, or 0 for the default grey.
  void Add(const double* numbers, size_t count)
  {
    const double grey[4] = { -1., -1., -1., -1. };
    const double* from = count ? numbers : grey;
    for (size_t i = 0; i < 4; ++i)
    {
      const double value = i < std::max<size_t>(count, 3) ? from[i] : -1.;
      this->Scale = value > 1. ? 1.f : this->Scale;
      this->Numbers.push_back(static_cast<float>(value));
    }
  }

  void Append(const ColorList& other)
  {
    this->Scale = std::min(this->Scale, other.Scale);
    this->Numbers.insert(this->Numbers.end(), other.Numbers.begin(), other.Numbers.end());
  }

  vtkSmartPointer<vtkUnsignedCharArray> ToArray() const
  {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName("RGBA");
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Numbers.size() / 4));
    for (size_t i = 0; i < this->Numbers.size(); ++i)
    {
      const float number = this->Numbers[i];
      const float level = std::round(this->Scale * number);
      const unsigned char missing = i % 4 == 3 ? 255 : DefaultGrey;
      array->SetValue(static_cast<vtkIdType>(i),
        number == -1.f ? missing : static_cast<unsigned char>(std::clamp(level, 0.f, 255.f)));
    }
    return array;
  }

private:
  std::vector<float> Numbers;
  float Scale = 255.f;
};

// The arrays of the vertices that the header announces.
class VertexArrays
{
public:
  VertexArrays(const Header& header, vtkIdType count)
    : Kind(header)
  {
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetNumberOfTuples(header.Normals ? count : 0);
    this->TextureCoordinates->SetName("TextureCoordinates");
    this->TextureCoordinates->SetNumberOfComponents(2);
    this->TextureCoordinates->SetNumberOfTuples(header.TextureCoordinates ? count : 0);
  }

  // Reads the values after the three coordinates of a vertex, on the same line.
  void Read(vtkIdType point, Words& words)
  {
    if (!this->Kind.Normals && !this->Kind.Colors && !this->Kind.TextureCoordinates)
    {
      return;
    }
    words.Rest(this->Numbers, "a number of a vertex");
    const size_t normal = this->Kind.Normals ? 3 : 0;
    const size_t texture = this->Kind.TextureCoordinates ? 2 : 0;
    const size_t color = this->Numbers.size() - std::min(this->Numbers.size(), normal + texture);
    const bool enough = this->Numbers.size() >= normal + texture;
    if (!enough || (this->Kind.Colors ? color != 3 && color != 4 : color != 0))
    {
      throw words.Unexpected(std::to_string(3 + this->Numbers.size()) + " numbers",
        "a vertex with what the header announces");
    }
    const double* number = this->Numbers.data();
    if (this->Kind.Normals)
    {
      this->Normals->SetTuple(point, number);
    }
    if (this->Kind.Colors)
    {
      this->Colors.Add(number + normal, color);
    }
    if (this->Kind.TextureCoordinates)
    {
      this->TextureCoordinates->SetTuple(point, number + normal + color);
    }
  }

  void GiveTo(vtkPolyData* output)
  {
    vtkPointData* data = output->GetPointData();
    if (this->Kind.Normals)
    {
      data->SetNormals(this->Normals);
    }
    if (this->Kind.Colors)
    {
      data->SetScalars(this->Colors.ToArray());
    }
    if (this->Kind.TextureCoordinates)
    {
      data->SetTCoords(this->TextureCoordinates);
    }
  }

private:
  const Header Kind;
  std::vector<double> Numbers;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> TextureCoordinates;
  ColorList Colors;
};

// The faces by kind of cell, each with a colour.
class Faces
{
public:
  void Read(Words& words, vtkIdType size, vtkIdType numberOfPoints)
  {
    const vtkIdType count = words.Whole(size, "the number of points of a face");
    if (count == 0)
    {
      throw words.Unexpected("0", "the number of points of a face, at least 1");
    }
    this->Points.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Points.push_back(words.Whole(numberOfPoints, "an index of a vertex"));
    }
    words.Rest(this->Numbers, "a colour of a face");
    const size_t color = this->Numbers.size();
    if (color > 4 || color == 2)
    {
      throw words.Unexpected(
        std::to_string(color) + " numbers", "a colour of 0, 1, 3 or 4 numbers after a face");
    }
    const int kind = count == 1 ? 0 : (count == 2 ? 1 : 2);
    this->Cells[kind]->InsertNextCell(count, this->Points.data());
    this->Colored = this->Colored || color > 1;
    this->Colors[kind].Add(this->Numbers.data(), color > 1 ? color : 0);
  }

  void GiveTo(vtkPolyData* output)
  {
    output->SetVerts(this->Cells[0]);
    output->SetLines(this->Cells[1]);
    output->SetPolys(this->Cells[2]);
    if (this->Colored)
    {
      // Cell data follow the order of vtkPolyData: vertices, lines, polygons.
      this->Colors[0].Append(this->Colors[1]);
      this->Colors[0].Append(this->Colors[2]);
      output->GetCellData()->SetScalars(this->Colors[0].ToArray());
    }
  }

private:
  std::vector<vtkIdType> Points;
  std::vector<double> Numbers;
  vtkNew<vtkCellArray> Cells[3];
  ColorList Colors[3];
  bool Colored = false;
};

// The whole file; the header is checked first, so that a huge file of another format is not read.
std::string Load(const char* fileName, Header& header)
{
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    throw Refusal{ vtkErrorCode::FileNotFoundError, "there is no such file" };
  }
  const std::string instead = vtkRelievoFileKind::FindInstead(fileName);
  if (!instead.empty())
  {
    throw Refusal{ vtkErrorCode::CannotOpenFileError, "expected a file, but " + instead };
  }
  vtksys::ifstream stream(fileName, std::ios::in | std::ios::binary);
  if (!stream)
  {
    throw Refusal{ vtkErrorCode::CannotOpenFileError, "the file cannot be opened" };
  }
  std::string text(4096, '\0');
  stream.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(stream.gcount()));
  Words words(text);
  const std::string_view word = words.Next("the header OFF");
  if (!ParseHeader(std::string(word), header))
  {
    throw Refusal{ vtkErrorCode::UnrecognizedFileTypeError,
      words.Unexpected(word, "the header OFF, COFF, NOFF or STOFF").Text };
  }
  if (words.NextOfLine() == "BINARY")
  {
    throw Refusal{ vtkErrorCode::UnrecognizedFileTypeError,
      "binary OFF files are not read; convert it to text" };
  }
  std::vector<char> block(1 << 20);
  while (stream)
  {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<size_t>(stream.gcount()));
  }
  return text;
}
}

//------------------------------------------------------------------------------
vtkRelievoOFFReader::vtkRelievoOFFReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoOFFReader::~vtkRelievoOFFReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkRelievoOFFReader::CanReadFile(const char* fileName)
{
  vtksys::ifstream stream(fileName ? fileName : "", std::ios::in | std::ios::binary);
  std::string text(4096, '\0');
  stream.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(stream.gcount()));
  Header header;
  try
  {
    Words words(text);
    const std::string word(words.Next("the header"));
    return ParseHeader(word, header) && words.NextOfLine() != "BINARY" ? 1 : 0;
  }
  catch (const Refusal&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
int vtkRelievoOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  // Returns 1 even on errors: after 0 the pipeline would add its own error, without a file name.
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("no file name is set: call SetFileName");
    return 1;
  }
  const auto refusal = FindRefusal([&]() { this->Parse(output); });
  if (refusal)
  {
    output->Initialize();
    this->SetErrorCode(refusal->Code);
    vtkErrorMacro("cannot read " << this->FileName << ": " << refusal->Text);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoOFFReader::Parse(vtkPolyData* output)
{
  Header header;
  const std::string text = Load(this->FileName, header);
  Words words(text);
  words.Next("the header");
  // A coordinate takes at least two characters, a face four: this limits the announced counts.
  const auto size = static_cast<vtkIdType>(text.size());
  const vtkIdType numberOfPoints = words.Count(size / 6 + 1, "vertices");
  const vtkIdType numberOfFaces = words.Count(size / 4 + 1, "faces");
  const std::string_view edges = words.NextOfLine();
  if (!edges.empty())
  {
    words.Parse<long long>(edges, "the number of edges");
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(
    this->OutputPointsPrecision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(numberOfPoints);
  VertexArrays arrays(header, numberOfPoints);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    double x[3];
    for (double& coordinate : x)
    {
      coordinate = words.Real("a coordinate of a vertex");
    }
    points->SetPoint(i, x);
    arrays.Read(i, words);
    if (i % 16384 == 0)
    {
      this->UpdateProgress(words.Progress());
      if (this->GetAbortExecute())
      {
        return;
      }
    }
  }

  Faces faces;
  for (vtkIdType i = 0; i < numberOfFaces; ++i)
  {
    faces.Read(words, size, numberOfPoints);
    if (i % 16384 == 0)
    {
      this->UpdateProgress(words.Progress());
      if (this->GetAbortExecute())
      {
        return;
      }
    }
  }
  output->SetPoints(points);
  arrays.GiveTo(output);
  faces.GiveTo(output);
  this->UpdateProgress(1.);
}

//------------------------------------------------------------------------------
void vtkRelievoOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
