// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Baseline.h"
#include "Command.h"
#include "Errors.h"
#include "Messages.h"
#include "Numbers.h"
#include "Outputs.h"
#include "Readers.h"
#include "SceneWork.h"
#include "Settings.h"
#include "Values.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRelievoBaseline.h"
#include "vtkRelievoComparisonReport.h"
#include "vtkRelievoFrameComparison.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace cli
{
namespace
{
namespace fs = std::filesystem;

// Exit statuses.
constexpr int Failed = 1;
constexpr int Different = 3;

class CompareCommand : public Command
{
public:
  CompareCommand()
    : Command("compare", "A B | A --render FILE... [options of render]",
        "compare explains how frame B differs from frame A: which objects, cells and lights, and "
        "why. Exit status: 0 alike, 1 the work failed, 2 the arguments were invalid, 3 different.")
  {
    this->Rows.AboutFile =
      "A and B are .exr files of `relievo render --baseline` or --exr, pictures (.png ...; then "
      "only the pictures are compared), or folders of these, whose files are matched by name.";
    this->Rows.Files = "exr|png";
    this->AddOutput("--json FILE.json", "the full result as JSON", this->JSON);
    this->AddOutput("--png-a FILE.png", "the picture of A, 8 bits", this->PNG[0]);
    this->AddOutput("--png-b FILE.png", "the picture of B, 8 bits", this->PNG[1]);
    this->AddOutput("--html FILE.html",
      "a report page in one file: both pictures, the pixels of each cause, values under the mouse",
      this->HTML);
    this->AddOutput(
      "--markdown FILE.md", "the table of causes as Markdown, for pull requests", this->Markdown);
    this->Add("--levels N",
      "tolerance for colours, and for shares such as shadows, in levels of 255, 0 to 255 (2)",
      [this](const std::string& value) {
        this->Comparison->SetColorLevels(words::ParseNumberFrom("--levels", value, 0.0, 255.0));
      });
    this->Add("--normal-angle DEG", "tolerance for normals, in degrees, 0 to 180 (0.02)",
      [this](const std::string& value) {
        this->Comparison->SetNormalAngle(
          words::ParseNumberFrom("--normal-angle", value, 0.0, 180.0));
      });
    this->Add("--depth-pixels P",
      "tolerance for depths, as the change of a surface's depth over P pixels, 0 to 1 (0.00390625, "
      "the step of OpenGL's grid)",
      [this](const std::string& value) {
        this->Comparison->SetDepthPixels(words::ParseNumberFrom("--depth-pixels", value, 0.0, 1.0));
      });
    // Run() splits the words at --render; this entry serves the help.
    this->Add("--render FILE...",
      "draws these files in place of B, with the options recorded in the baseline A; options of "
      "`relievo render` after --render replace recorded ones",
      [](const std::string&) {});
  }

  int Run(const std::vector<std::string>& words) override
  {
    const auto render = std::find(words.begin(), words.end(), "--render");
    const bool draws = render != words.end();
    std::vector<std::string> own(words.begin(), render);
    std::vector<std::string> drawn;
    for (auto word = draws ? std::next(render) : render; word != words.end(); ++word)
    {
      const bool isOwn = this->Has(*word);
      (isOwn ? own : drawn).push_back(*word);
      if (isOwn && std::next(word) != words.end())
      {
        own.push_back(*++word); // its value
      }
    }
    this->Take(own);
    if (this->Names.size() != (draws ? 1 : 2))
    {
      throw words::UsageError("compare: got " + std::to_string(this->Names.size()) +
        (this->Names.size() == 1 ? " file" : " files") + ", expected " +
        (draws ? "A alone before --render" : "A and B, or A --render FILE"));
    }
    const bool takesFolders = !draws && (IsFolder(this->Names[0]) || IsFolder(this->Names[1]));
    if (takesFolders && !(this->PNG[0].empty() && this->PNG[1].empty()))
    {
      throw words::UsageError("compare: --png-a and --png-b need two files, got folders");
    }
    const reading::Messages::Scope scope;
    reading::Outputs outputs;
    for (const auto& [option, path] : { std::pair("--json", &this->JSON),
           std::pair("--png-a", &this->PNG[0]), std::pair("--png-b", &this->PNG[1]),
           std::pair("--html", &this->HTML), std::pair("--markdown", &this->Markdown) })
    {
      if (!path->empty())
      {
        outputs.Add(option, *path, this->Names);
      }
    }
    bool alike = false;
    if (draws)
    {
      alike = this->CompareDrawn(drawn);
    }
    else if (takesFolders)
    {
      alike = this->CompareFolders();
    }
    else
    {
      this->Read(true, this->Names[0]);
      this->Read(false, this->Names[1]);
      alike = this->Compare(this->Names[0] + ", " + this->Names[1]);
      this->Found = this->Comparison->GetJSON();
      std::fputs(this->Comparison->GetText().c_str(), stdout);
    }
    if (!this->JSON.empty())
    {
      Write(outputs, this->JSON, this->Found + '\n');
    }
    if (!this->HTML.empty())
    {
      Write(outputs, this->HTML, this->Report->GetHTML());
    }
    if (!this->Markdown.empty())
    {
      Write(outputs, this->Markdown, this->Report->GetMarkdown());
    }
    WritePNG(this->Comparison->GetBaseline(), this->PNG[0], outputs);
    WritePNG(this->Comparison->GetFrame(), this->PNG[1], outputs);
    outputs.Commit();
    return this->HasFailed ? Failed : alike ? 0 : Different;
  }

private:
  // Whether the word is an option of this command; render has none of these names.
  bool Has(const std::string& word) const
  {
    return std::any_of(this->Rows.Options.begin(), this->Rows.Options.end(),
      [&word](const vtkRelievoOption& option) { return option.Name == word; });
  }

  static void Write(
    const reading::Outputs& outputs, const std::string& path, const std::string& text)
  {
    std::ofstream file(outputs.Temporary(path), std::ios::binary);
    file << text;
    file.close();
    if (!file)
    {
      throw words::WorkError(path + ": cannot be written; is the disk full?");
    }
  }

  static bool IsFolder(const std::string& path)
  {
    std::error_code error;
    return fs::is_directory(path, error);
  }

  // Writes the picture of a frame unless the path is empty.
  static void WritePNG(
    vtkImageData* frame, const std::string& path, const reading::Outputs& outputs)
  {
    if (path.empty())
    {
      return;
    }
    const vtkSmartPointer<vtkImageData> picture = scene::MakePicture(frame);
    if (!picture)
    {
      throw words::WorkError(path + ": cannot be written: the frame has layers but no picture");
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(picture);
    writer->SetFileName(outputs.Temporary(path).c_str());
    writer->Write();
    reading::Messages::Check(
      path, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
  }

  // Throws the comparison's error, so that it is reported once.
  void Check(bool done, const std::string& before = {})
  {
    if (!done)
    {
      const std::string text = this->Comparison->GetFailureText();
      throw words::WorkError(before.empty() ? text : before + ": " + text);
    }
  }

  void Read(bool isBaseline, const std::string& path)
  {
    this->Check(isBaseline ? this->Comparison->ReadBaseline(path.c_str())
                           : this->Comparison->ReadFrame(path.c_str()));
  }

  // `showsAlike`: whether the page has the pictures of frames that are alike, too.
  bool Compare(const std::string& files, bool showsAlike = true)
  {
    this->Check(this->Comparison->Compare(), files);
    const bool alike = this->Comparison->GetAlike();
    if (!this->HTML.empty() || !this->Markdown.empty())
    {
      this->Report->Add(
        files.c_str(), this->Comparison, !this->HTML.empty() && (showsAlike || !alike));
    }
    return alike;
  }

  //----------------------------------------------------------------------------
  // Draws the files with the baseline's options, except for the given ones, and compares.
  bool CompareDrawn(const std::vector<std::string>& given)
  {
    const std::string& path = this->Names.front();
    this->Read(true, path);
    const std::optional<scene::Settings> recorded =
      scene::GetRecorded(this->Comparison->GetBaseline(), path);
    if (!recorded)
    {
      throw words::UsageError(
        path + ": records no options, expected a file of `relievo render --baseline`");
    }
    scene::Settings settings = *recorded;
    const scene::Settings other = scene::Settings::FromWords(given);
    settings.TakeChanges(scene::Settings(), other);
    settings.Files = other.Files;
    vtkRelievoScene* scene = GetScene();
    SetWords(scene, settings.GetWords());
    vtkNew<vtkImageData> image;
    {
      const SceneSteps steps(scene);
      const bool done = scene->CaptureBaseline(
        image, vtkRelievoBaseline::IsPortable(this->Comparison->GetBaseline()));
      CheckDone(done, scene->GetFailure(), scene->GetFailureText());
    }
    PrintMessages(scene);
    this->Comparison->SetFrame(image);
    const bool alike = this->Compare(path);
    this->Found = this->Comparison->GetJSON();
    std::fputs(this->Comparison->GetText().c_str(), stdout);
    return alike;
  }

  //----------------------------------------------------------------------------
  // The pictures in a folder and below, as paths relative to the folder.
  static std::set<std::string> ListPictures(const std::string& folder)
  {
    std::set<std::string> names;
    std::error_code error;
    for (fs::recursive_directory_iterator each(folder, error), end; !error && each != end;
         each.increment(error))
    {
      std::error_code unknown; // set for a broken link, which is skipped
      const std::string extension = reading::ExtensionOf(each->path().string());
      if (each->is_regular_file(unknown) && (extension == ".exr" || extension == ".png"))
      {
        // Not fs::relative(), which resolves links.
        names.insert(each->path().lexically_relative(folder).generic_string());
      }
    }
    if (error)
    {
      throw words::WorkError(folder + ": cannot be read: " + error.message());
    }
    return names;
  }

  // Compares the files of this name in both folders, and adds the result to the entry. A pair that
  // cannot be compared is reported, and the others are compared all the same.
  bool ComparePair(const std::string& name, nlohmann::ordered_json& entry)
  {
    try
    {
      this->Read(true, (fs::path(this->Names[0]) / name).string());
      this->Read(false, (fs::path(this->Names[1]) / name).string());
      const bool alike = this->Compare(name, false);
      entry.update(nlohmann::ordered_json::parse(this->Comparison->GetJSON()));
      if (!alike)
      {
        std::printf("%s: %s", name.c_str(), this->Comparison->GetText().c_str());
      }
      return alike;
    }
    catch (const words::WorkError& error)
    {
      this->HasFailed = true;
      entry["alike"] = false;
      entry["failure"] = error.what();
      this->Report->AddNotCompared(name.c_str(), error.what());
      std::printf("%s: not compared: %s\n", name.c_str(), error.what());
      return false;
    }
  }

  bool CompareFolders()
  {
    const std::string& a = this->Names[0];
    const std::string& b = this->Names[1];
    if (!IsFolder(a) || !IsFolder(b))
    {
      throw words::UsageError("compare: got a folder, " + (IsFolder(a) ? a : b) +
        ", and a file, expected two folders or two files");
    }
    const std::set<std::string> sides[2] = { ListPictures(a), ListPictures(b) };
    std::set<std::string> all = sides[0];
    all.insert(sides[1].begin(), sides[1].end());
    if (all.empty())
    {
      throw words::WorkError(a + ", " + b + ": contain no .exr or .png");
    }
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    std::size_t different = 0;
    for (const std::string& name : all)
    {
      nlohmann::ordered_json entry = { { "file", name } };
      const bool isOld = sides[0].count(name) != 0;
      if (!isOld || sides[1].count(name) == 0)
      {
        entry["alike"] = false;
        entry["missing_in"] = isOld ? b : a;
        const std::string reason = "missing in " + (isOld ? b : a);
        this->Report->AddNotCompared(name.c_str(), reason.c_str());
        std::printf("%s: %s\n", name.c_str(), reason.c_str());
        ++different;
      }
      else if (!this->ComparePair(name, entry))
      {
        ++different;
      }
      files.push_back(entry);
    }
    std::printf("%s of %s different\n", std::to_string(different).c_str(),
      all.size() == 1 ? "1 file" : (std::to_string(all.size()) + " files").c_str());
    this->Found = nlohmann::ordered_json({ { "alike", different == 0 }, { "files", files } })
                    .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    return different == 0;
  }

  vtkNew<vtkRelievoFrameComparison> Comparison;
  vtkNew<vtkRelievoComparisonReport> Report;
  std::string JSON, HTML, Markdown, Found;
  std::string PNG[2];     // of A and B
  bool HasFailed = false; // a pair in folders could not be compared
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeCompare()
{
  return std::make_unique<CompareCommand>();
}
}
