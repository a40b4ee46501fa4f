// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "Check.h"
#include "LeakCounter.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <iostream>
#include <mutex>

namespace relievoTest
{
namespace
{
std::mutex Mutex;
std::vector<std::string> Allowed;
std::vector<ExpectMessage*> Expected;
}

//------------------------------------------------------------------------------
bool TakeExpectedMessage(const std::string& message)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  const bool taken = std::any_of(Expected.rbegin(), Expected.rend(), [&](ExpectMessage* expect) {
    const bool mine = message.find(expect->Text) != std::string::npos;
    if (mine)
    {
      expect->Taken.push_back(message);
    }
    return mine;
  });
  return taken || std::any_of(Allowed.begin(), Allowed.end(), [&](const std::string& text) {
    return message.find(text) != std::string::npos;
  });
}

namespace
{
// The output window of a test: messages of VTK become failures, unless expected.
class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { this->Take("VTK error", text); }
  void DisplayWarningText(const char* text) override { this->Take("VTK warning", text); }
  void DisplayGenericWarningText(const char* text) override { this->Take("VTK warning", text); }
  void DisplayText(const char* text) override { std::cout << text; }

private:
  void Take(const char* kind, const char* text)
  {
    if (!TakeExpectedMessage(text))
    {
      Fail(kind, 0, text);
    }
  }
};
vtkStandardNewMacro(Window);
}

//------------------------------------------------------------------------------
struct Session::Internals
{
  vtkSmartPointer<vtkOutputWindow> Previous = vtkOutputWindow::GetInstance();
  LeakCounter Leaks;
};

//------------------------------------------------------------------------------
Session::Session()
  : Internal(new Internals)
{
  vtkSmartPointer<Window> window = vtkSmartPointer<Window>::New();
  vtkOutputWindow::SetInstance(window);
}

//------------------------------------------------------------------------------
Session::~Session()
{
  vtkOutputWindow::SetInstance(this->Internal->Previous);
  const std::lock_guard<std::mutex> lock(Mutex);
  Allowed.clear();
}

//------------------------------------------------------------------------------
void Session::Allow(const std::string& text)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  Allowed.push_back(text);
}

//------------------------------------------------------------------------------
int Session::Result()
{
  vtkOutputWindow::SetInstance(this->Internal->Previous);
  RELIEVO_CHECK_THAT(CanCountObjects(), "living VTK objects cannot be counted in this build");
  const std::string leaks = this->Internal->Leaks.Leaks();
  RELIEVO_CHECK_THAT(leaks.empty(), "VTK objects still alive: " + leaks);
  const int failures = NumberOfFailures();
  if (failures > 0)
  {
    std::cerr << failures << " failure(s)\n";
  }
  return failures == 0 ? 0 : 1;
}

//------------------------------------------------------------------------------
ExpectMessage::ExpectMessage(const std::string& text)
  : Text(text)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  Expected.push_back(this);
}

//------------------------------------------------------------------------------
ExpectMessage::~ExpectMessage()
{
  {
    const std::lock_guard<std::mutex> lock(Mutex);
    Expected.erase(std::remove(Expected.begin(), Expected.end(), this), Expected.end());
  }
  RELIEVO_CHECK_THAT(!this->Taken.empty(), "no VTK message contained '" + this->Text + "'");
}

//------------------------------------------------------------------------------
int ExpectMessage::Count() const
{
  return static_cast<int>(this->Taken.size());
}

//------------------------------------------------------------------------------
const std::vector<std::string>& ExpectMessage::Messages() const
{
  return this->Taken;
}
}
