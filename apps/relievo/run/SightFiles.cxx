// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SightFiles.h"

#include "DataSets.h"
#include "Errors.h"
#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Readers.h"
#include "UpAxis.h"

#include "vtkAppendPolyData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoGeoTIFFWriter.h"
#include "vtkRelievoRaster.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoSightAlgorithm.h"
#include "vtkXMLPolyDataWriter.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace cli
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& file, reading::ReadContext& context)
{
  reading::CheckReadable(file);
  vtkNew<vtkAppendPolyData> all;
  reading::ForEachDataSet(reading::ReadSurface(file, false, false, context),
    [&all](vtkDataSet* data) { all->AddInputData(vtkPolyData::SafeDownCast(data)); });
  if (all->GetNumberOfInputConnections(0) > 0)
  {
    all->Update();
  }
  vtkPolyData* mesh = all->GetOutput();
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    throw words::WorkError(file + ": it has no surface");
  }
  return mesh;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadMesh(
  const std::string& file, const std::vector<std::string>& folders, reading::Progress& progress)
{
  reading::ReadContext context(progress, folders);
  return ReadMesh(file, context);
}

//------------------------------------------------------------------------------
int ReadMeshes(const std::vector<std::string>& files, const std::vector<std::string>& folders,
  const std::string& rays, vtkRelievoSightAlgorithm* filter, reading::Progress& progress)
{
  for (const std::string& folder : folders)
  {
    reading::CheckFolder(folder);
  }
  reading::ReadContext context(progress, folders);
  int up = 1;
  vtkNew<vtkRelievoRayScene> scene;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(files[i], context);
    if (i == 0)
    {
      up = reading::FindUpAxis(files[i], mesh->GetBounds());
    }
    filter->AddInputDataObject(i == 0 ? 0 : 1, mesh);
    scene->AddData(mesh);
  }
  if (!rays.empty())
  {
    std::error_code trouble;
    const bool exists = std::filesystem::exists(rays, trouble);
    progress.Begin((exists ? "opening " : "writing ") + rays);
    const bool done = exists ? scene->Read(rays) : scene->Write(rays);
    reading::Messages::Check("--rays", !done, "the trees were not used");
    filter->SetScene(scene);
  }
  return up;
}

//------------------------------------------------------------------------------
bool CheckRaster(vtkRelievoSightAlgorithm* filter, const std::string& output)
{
  const bool isRaster = reading::ExtensionOf(output) == ".tif";
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(filter->GetInputDataObject(0, 0));
  if (isRaster &&
    !(mesh->GetFieldData()->GetArray(relievo::raster::Size) &&
      mesh->GetFieldData()->GetArray(relievo::raster::Transform) &&
      mesh->GetPointData()->GetArray(relievo::raster::Cell)))
  {
    throw words::UsageError("-o " + output +
      ": the mesh is no raster; expected a GeoTIFF as the first FILE, or -o FILE.vtp");
  }
  return isRaster;
}

//------------------------------------------------------------------------------
void WriteText(const std::string& text, const std::string& option, const std::string& path,
  const reading::Outputs& outputs)
{
  std::ofstream file(outputs.Temporary(path), std::ios::binary);
  errno = 0;
  file << text;
  file.close();
  reading::Messages::Check(option + " " + path, !file, std::strerror(errno));
}

//------------------------------------------------------------------------------
void WriteMesh(vtkPolyData* mesh, const std::string& option, const std::string& path,
  const reading::Outputs& outputs, reading::Progress& progress)
{
  progress.Begin("writing " + path);
  if (reading::ExtensionOf(path) == ".tif")
  {
    vtkNew<vtkRelievoGeoTIFFWriter> writer;
    writer->SetInputData(mesh);
    writer->SetFileName(outputs.Temporary(path).c_str());
    const bool written = writer->Write();
    try
    {
      reading::Messages::Check(option + " " + path, !written, "the raster was not written");
    }
    catch (const words::WorkError& error)
    {
      throw words::WorkError(outputs.WithGivenNames(error.what()));
    }
    return;
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  // VTK's mesh writer crashes on a full disk, so it writes to memory.
  writer->WriteToOutputStringOn();
  // Not appended: VTK before 9.3.1 cannot read appended data with Debian's patched expat.
  writer->SetDataModeToBinary();
  writer->SetCompressionLevel(1); // half the time, and files that are hardly larger
  progress.Observe(writer);
  const bool made = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
  reading::Messages::Check(
    option + " " + path, !made, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  WriteText(writer->GetOutputString(), option, path, outputs);
}
}
