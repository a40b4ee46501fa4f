// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Errors.h"
#include "FileHash.h"
#include "MeshParts.h"
#include "Messages.h"
#include "Outputs.h"
#include "Progress.h"
#include "SightFiles.h"
#include "Values.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoSunExposure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>

namespace cli
{
namespace
{
class SunCommand : public Command
{
public:
  SunCommand()
    : Command("sun", "FILE...",
        "sun computes by rays how long the sun shines on a mesh, and writes the mesh with "
        "the arrays sun_hours and insolation (hours weighted by the cosine between the sun "
        "and the normal), and by --irradiance with its irradiation in kWh/m2. The first FILE is "
        "the mesh, the others shade it. North is z, -z or "
        "y where x, y or z points up.")
  {
    this
      ->Add("--place LATITUDE,LONGITUDE",
        "degrees, -90 to 90 and -180 to 180; north and east are positive",
        [this](const std::string& value) { this->TakePlace(value); })
      .Missing = "no place; give --place LATITUDE,LONGITUDE";
    this
      ->Add("--dates FIRST[:LAST[:EVERY]]",
        "first and last day, both included, such as 2026-01-01:2026-12-31:7; one day in "
        "EVERY stands for all of them",
        [this](const std::string& value) { this->TakeDates(value); })
      .Missing = "no dates; give --dates FIRST[:LAST[:EVERY]]";
    this->AddMeshOptions(".vtp", ".tif");
    this->AddUpOption();
    this->AddParameters(this->Sun->GetParameters(),
      { { "latitude", "" }, { "longitude", "" }, { "first_day", "" }, { "last_day", "" },
        { "day_step", "" }, { "step", "--step MINUTES" }, { "up_axis", "" },
        { "sky_samples", "--sky N" }, { "time_zone", "--time-zone HOURS" },
        { "weather_file", "--weather FILE.epw" } });
    std::find_if(this->Rows.Options.begin(), this->Rows.Options.end(),
      [](const vtkRelievoOption& option) { return option.Name == "--weather"; })
      ->Files = "epw";
    this->AddPartOption("cells");
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->TakeMeshes(words);
    if (*this->Sun->GetWeatherFile() != '\0' && this->Sun->GetIrradiance() == 0)
    {
      throw words::UsageError(
        "--weather: got no irradiance, expected --irradiance isotropic or perez");
    }
    const std::string weather = this->Sun->CheckWeatherFile();
    if (!weather.empty())
    {
      throw words::WorkError("--weather " + weather);
    }
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    outputs.Add("-o", this->File, this->Names);
    reading::Progress progress;
    MeshParts parts(MeshParts::GetFolder(this->File));
    const int up =
      ReadMeshes(this->Names, this->AllowedFolders, this->RayFile, this->Sun, progress);
    if (CheckRaster(this->Sun, this->File))
    {
      this->Sun->PointsOn();
    }
    this->Sun->SetUpAxis(this->Up < 0 ? up : this->Up);
    if (this->IsPart && !parts.Begin(this->Rows.Name, this->DescribeSun(), this->Sun, this->Part))
    {
      return 0;
    }
    progress.Begin("following the sun");
    progress.Observe(this->Sun);
    this->Sun->Update();
    reading::Messages::Check("sun");
    if (this->IsPart)
    {
      parts.End(this->Sun, this->Part, progress);
      return 0;
    }
    WriteMesh(this->Sun->GetOutput(), "-o", this->File, outputs, progress);
    outputs.Commit();
    progress.End();
    this->Print(this->Sun->GetOutput());
    return 0;
  }

private:
  // The words, the axis that points up, which may come from the first file, and the weather.
  std::string DescribeSun()
  {
    const std::string weather = this->Sun->GetWeatherFile();
    return this->GetWords() + " --up=" + std::string(1, "xyz"[this->Sun->GetUpAxis()]) +
      (weather.empty() ? "" : " " + dataset::FileHash::OfFile(weather));
  }

  void TakePlace(const std::string& value)
  {
    const std::vector<double> place =
      words::ParseNumbers("--place", value, 2, "LATITUDE,LONGITUDE");
    if (std::abs(place[0]) > 90. || std::abs(place[1]) > 180.)
    {
      words::RefuseValue(
        "--place", value, "a latitude from -90 to 90, a longitude from -180 to 180");
    }
    this->Sun->SetLatitude(place[0]);
    this->Sun->SetLongitude(place[1]);
  }

  void TakeDates(const std::string& value)
  {
    static const std::regex form("([0-9]{4})-([0-9]{2})-([0-9]{2})");
    const std::vector<std::string> parts = words::Split(value, ':');
    int days[2][3] = {}; // first and last
    for (std::size_t i = 0; i < 2; ++i)
    {
      const std::string& day = parts[i < parts.size() ? i : 0];
      std::smatch numbers;
      if (parts.size() > 3 || !std::regex_match(day, numbers, form))
      {
        words::RefuseValue(
          "--dates", value, "FIRST[:LAST[:EVERY]], such as 2026-06-21 or 2026-01-01:2026-12-31:7");
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        days[i][k] = std::stoi(numbers[k + 1].str());
      }
    }
    const std::string error = vtkRelievoSunExposure::CheckDays(days[0], days[1]);
    if (!error.empty())
    {
      throw words::UsageError("--dates " + value + ": " + error);
    }
    this->Sun->SetFirstDay(days[0]);
    this->Sun->SetLastDay(days[1]);
    if (parts.size() == 3)
    {
      this->Sun->SetDayStep(words::ParseWhole("--dates " + value, parts[2], 1, 366));
    }
  }

  void Print(vtkPolyData* mesh)
  {
    vtkDataSetAttributes* where = mesh->GetCellData();
    where = this->Sun->GetPoints() ? mesh->GetPointData() : where;
    vtkDataArray* hours = where->GetArray("sun_hours");
    double sum = 0.;
    for (vtkIdType i = 0; i < hours->GetNumberOfTuples(); ++i)
    {
      sum += hours->GetTuple1(i);
    }
    std::printf("%s: %.1f hours of sun in the mean of %lld %s, of %.1f\n", this->File.c_str(),
      sum / static_cast<double>(hours->GetNumberOfTuples()),
      static_cast<long long>(hours->GetNumberOfTuples()),
      this->Sun->GetPoints() ? "points" : "cells",
      mesh->GetFieldData()->GetArray("possible_hours")->GetTuple1(0));
    if (vtkDataArray* energy = where->GetArray("irradiation"))
    {
      double whole = 0.;
      double bound = 0.;
      for (vtkIdType i = 0; i < energy->GetNumberOfTuples(); ++i)
      {
        whole += energy->GetTuple1(i);
        bound = std::max(bound, where->GetArray("irradiation_bound")->GetTuple1(i));
      }
      std::printf(
        "%s: %.1f kWh/m2 in their mean, open level ground has %.1f; errors of the sampling "
        "are at most %.2f\n",
        this->File.c_str(), whole / static_cast<double>(energy->GetNumberOfTuples()),
        mesh->GetFieldData()->GetArray("open_irradiation")->GetTuple1(0), bound);
    }
  }

  vtkNew<vtkRelievoSunExposure> Sun;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeSun()
{
  return std::make_unique<SunCommand>();
}
}
