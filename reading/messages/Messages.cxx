// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "Errors.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkRelievoReaderProcess.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <mutex>

namespace reading
{
namespace
{
class MessageCollector : public vtkOutputWindow
{
public:
  static MessageCollector* New();
  vtkTypeMacro(MessageCollector, vtkOutputWindow);

  void DisplayText(const char* text) override { this->Keep(text, false); }
  void DisplayErrorText(const char* text) override { this->Keep(text, true); }
  void DisplayWarningText(const char* text) override { this->Keep(text, false); }
  void DisplayGenericWarningText(const char* text) override { this->Keep(text, false); }
  void DisplayDebugText(const char*) override {}

  std::vector<std::string> Take(std::vector<std::string> MessageCollector::*list)
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    std::vector<std::string> taken;
    taken.swap(this->*list);
    return taken;
  }

  void Add(std::vector<std::string> MessageCollector::*list, const std::string& text)
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    std::vector<std::string>& all = this->*list;
    if (!text.empty() && std::find(all.begin(), all.end(), text) == all.end())
    {
      all.push_back(text);
    }
  }

  std::vector<std::string> Errors, Warnings;
  std::vector<std::string> Named; // warnings that already name their subject
  std::vector<std::string> Notes;

private:
  void Keep(const char* text, bool error)
  {
    const std::string line = OneLine(text ? text : "");
    // VTK 9.4 and later look for a display before they open a window without one; CheckDisplay
    // reports the case that both are missing.
    if (!error && line.compare(0, 23, "bad X server connection") == 0)
    {
      return;
    }
    // VTK writes ranges of arrays with NaN that its own readers reject and ignore.
    if (line.rfind("Error reading InformationKey element for vtkDataArray::", 0) == 0)
    {
      return;
    }
    if (Messages::TellsOfMemory(line))
    {
      vtkRelievoReaderProcess::LackMemory(); // before Debian's VTK aborts
    }
    // Readers of legacy files report a truncated file as a warning, "Error reading ...".
    this->Add(error || line.compare(0, 5, "Error") == 0 ? &MessageCollector::Errors
                                                        : &MessageCollector::Warnings,
      line);
  }

  // "ERROR: In a.cxx, line 1\nvtkThing (0x1): text" becomes "text", on one line.
  static std::string OneLine(std::string text)
  {
    const std::string::size_type line = text.find(", line ");
    if (line != std::string::npos)
    {
      text.erase(0, text.find('\n', line));
      const std::string::size_type address = text.find("): ");
      if (text.compare(0, 4, "\nvtk") == 0 && address != std::string::npos)
      {
        text.erase(0, address + 3);
      }
    }
    // VTK lists numbers and its source line.
    if (text.find("OpenGL errors detected") != std::string::npos)
    {
      const bool lacks = text.find("Out of memory") != std::string::npos;
      return std::string("OpenGL failed") + (lacks ? ": out of memory" : "") +
        ": the scene or the picture exceeds this driver's limits; give a smaller --size, "
        "fewer samples or smaller files, or another driver, such as Mesa's "
        "(LIBGL_ALWAYS_SOFTWARE=1)";
    }
    std::string words;
    bool gap = false;
    for (const char letter : text)
    {
      if (static_cast<unsigned char>(letter) <= ' ')
      {
        gap = !words.empty();
        continue;
      }
      words += gap ? " " : "";
      words += letter;
      gap = false;
    }
    return words;
  }

  std::mutex Lock; // readers may report from VTK's worker threads
};
vtkStandardNewMacro(MessageCollector);

std::string NameSubject(const std::string& subject, const std::string& text)
{
  return text.find(subject) == std::string::npos ? subject + ": " + text : text;
}

MessageCollector* Collector()
{
  static const vtkNew<MessageCollector> collector;
  return collector;
}

// State replaced by scopes, while any lives.
struct Replaced
{
  std::mutex Lock;
  int Scopes = 0;
  vtkSmartPointer<vtkOutputWindow> Window;
  vtkLogger::Verbosity Verbosity = vtkLogger::VERBOSITY_INVALID;
  vtkTypeBool Display = 1;
};

Replaced& GetReplaced()
{
  static Replaced replaced;
  return replaced;
}
}

//------------------------------------------------------------------------------
Messages::Scope::Scope()
{
  Replaced& replaced = GetReplaced();
  const std::lock_guard<std::mutex> guard(replaced.Lock);
  if (replaced.Scopes++ == 0)
  {
    replaced.Window = vtkOutputWindow::GetInstance();
    replaced.Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
    vtkOutputWindow::SetInstance(Collector());
    replaced.Display = vtkObject::GetGlobalWarningDisplay();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // the logger prints each text again
    vtkObject::GlobalWarningDisplayOn(); // otherwise VTK reports no error at all
  }
}

//------------------------------------------------------------------------------
Messages::Scope::~Scope()
{
  Replaced& replaced = GetReplaced();
  const std::lock_guard<std::mutex> guard(replaced.Lock);
  if (--replaced.Scopes == 0)
  {
    vtkOutputWindow::SetInstance(replaced.Window);
    vtkLogger::SetStderrVerbosity(replaced.Verbosity);
    vtkObject::SetGlobalWarningDisplay(replaced.Display);
    replaced.Window = nullptr;
  }
}

//------------------------------------------------------------------------------
bool Messages::TellsOfMemory(const std::string& text)
{
  return text.find("Unable to allocate") != std::string::npos;
}

//------------------------------------------------------------------------------
void Messages::Note(const std::string& text)
{
  Collector()->Add(&MessageCollector::Notes, text);
}

//------------------------------------------------------------------------------
std::vector<std::string> Messages::TakeNotes()
{
  return Collector()->Take(&MessageCollector::Notes);
}

//------------------------------------------------------------------------------
void Messages::Warn(const std::string& text)
{
  Collector()->Add(&MessageCollector::Named, text);
}

//------------------------------------------------------------------------------
std::vector<std::string> Messages::TakeWarnings()
{
  std::vector<std::string> warnings = Collector()->Take(&MessageCollector::Named);
  for (const std::string& warning : Collector()->Take(&MessageCollector::Warnings))
  {
    warnings.push_back(warning);
  }
  return warnings;
}

//------------------------------------------------------------------------------
std::vector<std::string> Messages::TakeWarningsOn(const std::string& subject)
{
  std::vector<std::string> warnings = Collector()->Take(&MessageCollector::Warnings);
  for (std::string& warning : warnings)
  {
    warning = NameSubject(subject, warning);
  }
  return warnings;
}

//------------------------------------------------------------------------------
void Messages::Check(const std::string& subject, bool failed, const std::string& otherwise)
{
  const auto named = [&subject](const std::string& text) { return NameSubject(subject, text); };
  for (const std::string& warning : TakeWarningsOn(subject))
  {
    Warn(warning);
  }
  const std::vector<std::string> errors = Collector()->Take(&MessageCollector::Errors);
  for (const std::string& error : errors)
  {
    // The first error is the cause. The others are its echoes up VTK's pipeline, which begin like
    // this and hold nothing but addresses.
    if (error.compare(0, 13, "Algorithm vtk") != 0)
    {
      throw WorkError(named(error));
    }
  }
  if (failed || !errors.empty())
  {
    throw WorkError(named(otherwise.empty() ? "VTK failed without saying why" : otherwise));
  }
}
}
