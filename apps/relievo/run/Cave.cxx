// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cave.h"

#include "CaveOptions.h"
#include "Errors.h"
#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRelievoCaves.h"
#include "vtkXMLImageDataWriter.h"

#include <cstdio>
#include <regex>
#include <utility>

namespace cli
{
namespace
{
// What the filter says of its parameters, by the options that set them.
std::string NameOptions(std::string text)
{
  const std::pair<const char*, const char*> names[] = { { "TunnelWidth", "--width" },
    { "VerticalScale", "--vertical-scale" }, { "\\bScale", "--scale" }, { "\\bSize\\b", "--size" },
    { "Origin", "--origin" }, { "Spacing", "--spacing" } };
  for (const auto& [parameter, option] : names)
  {
    text = std::regex_replace(text, std::regex(parameter), option);
  }
  return text;
}
}

//------------------------------------------------------------------------------
void Cave(const CaveOptions& options)
{
  const scene::Messages::Scope scope;
  scene::Outputs outputs;
  outputs.Add("-o", options.File, {});
  vtkNew<vtkRelievoCaves> caves;
  caves->SetSize(options.Size[0], options.Size[1], options.Size[2]);
  caves->SetOrigin(options.Origin[0], options.Origin[1], options.Origin[2]);
  caves->SetSpacing(options.Spacing[0], options.Spacing[1], options.Spacing[2]);
  caves->SetSeed(options.Seed);
  caves->SetTunnelWidth(options.Width);
  caves->SetScale(options.Scale);
  caves->SetVerticalScale(options.VerticalScale);
  caves->SetUp(options.Up);
  caves->SetContent(options.Content);
  {
    scene::Progress progress;
    progress.Begin("making caves");
    progress.Observe(caves);
    caves->Update();
    try
    {
      scene::Messages::Check("cave", caves->GetErrorCode() != vtkErrorCode::NoError);
    }
    catch (const scene::WorkError& error)
    {
      const std::string text = NameOptions(error.what());
      if (text.find(", expected ") != std::string::npos) // and not that the memory is too small
      {
        throw scene::UsageError(text);
      }
      throw scene::WorkError(text);
    }
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(caves->GetOutput());
    writer->SetFileName(outputs.Temporary(options.File).c_str());
    // Not appended: Debian's mended expat keeps VTK before 9.3.1 from reading that.
    writer->SetDataModeToBinary();
    progress.Begin("writing " + options.File);
    progress.Observe(writer);
    const bool written = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
    scene::Messages::Check(
      "-o " + options.File, !written, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
  outputs.Commit();
  const auto samples = static_cast<double>(caves->GetOutput()->GetNumberOfPoints());
  std::printf("%s: %.0f samples, %.2f %% air, %.2f evaluations of noise a sample\n",
    options.File.c_str(), samples,
    100. * static_cast<double>(caves->GetNumberOfAirSamples()) / samples,
    static_cast<double>(caves->GetNumberOfEvaluations()) / samples);
}
}
