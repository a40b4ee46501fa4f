// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
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

namespace cli
{
namespace
{
class CaveCommand : public Command
{
public:
  CaveCommand()
    : Command("cave", "", "cave makes winding caves from a seed and writes them as an image.")
  {
    this->AddOutput("-o FILE.vti", "the image", this->File).Missing =
      "no file to write; give -o FILE.vti";
    this->Caves->SetSize(128, 64, 128);
    this->Caves->SetUp(1);
    this->AddParameters(this->Caves->GetParameters(),
      { { "tunnel_width", "--width W" }, { "scale", "--scale S" },
        { "vertical_scale", "--vertical-scale V" }, { "up", "--up AXIS" } });
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->Take(words);
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    outputs.Add("-o", this->File, {});
    {
      reading::Progress progress;
      progress.Begin("making caves");
      progress.Observe(this->Caves);
      this->Caves->Update();
      try
      {
        reading::Messages::Check("cave", this->Caves->GetErrorCode() != vtkErrorCode::NoError);
      }
      catch (const words::WorkError& error)
      {
        const std::string text = this->NameOptions(error.what());
        if (text.find(", expected ") != std::string::npos) // not an error about memory
        {
          throw words::UsageError(text);
        }
        throw words::WorkError(text);
      }
      vtkNew<vtkXMLImageDataWriter> writer;
      writer->SetInputData(this->Caves->GetOutput());
      writer->SetFileName(outputs.Temporary(this->File).c_str());
      // Not appended: VTK before 9.3.1 cannot read appended data with Debian's patched expat.
      writer->SetDataModeToBinary();
      progress.Begin("writing " + this->File);
      progress.Observe(writer);
      const bool written = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
      reading::Messages::Check(
        "-o " + this->File, !written, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
    }
    outputs.Commit();
    const auto samples = static_cast<double>(this->Caves->GetOutput()->GetNumberOfPoints());
    std::printf("%s: %.0f samples, %.2f %% air, %.2f evaluations of noise a sample\n",
      this->File.c_str(), samples,
      100. * static_cast<double>(this->Caves->GetNumberOfAirSamples()) / samples,
      static_cast<double>(this->Caves->GetNumberOfEvaluations()) / samples);
    return 0;
  }

private:
  vtkNew<vtkRelievoCaves> Caves;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeCave()
{
  return std::make_unique<CaveCommand>();
}
}
