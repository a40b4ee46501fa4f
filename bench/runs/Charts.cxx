// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Charts.h"

#include <vtksys/Process.h>
#include <vtksys/SystemTools.hxx>

#include <iostream>

namespace relievoBench
{
namespace
{
constexpr char Script[] = RELIEVO_CHARTS;
constexpr char Python[] = RELIEVO_CHARTS_PYTHON;
constexpr int NoMatplotlib = 3; // exit status of charts.py
}

//------------------------------------------------------------------------------
bool DrawCharts(const std::string& bench, const std::string& folder)
{
  int status = NoMatplotlib;
  std::string said;
  if (vtksys::SystemTools::FileExists(Script, true))
  {
    const char* const command[] = { Python, Script, folder.c_str(), bench.c_str(), nullptr };
    vtksysProcess* process = vtksysProcess_New();
    vtksysProcess_SetCommand(process, command);
    vtksysProcess_Execute(process);
    char* data = nullptr;
    int length = 0;
    while (vtksysProcess_WaitForData(process, &data, &length, nullptr))
    {
      said.append(data, static_cast<std::size_t>(length));
    }
    vtksysProcess_WaitForExit(process, nullptr);
    const int state = vtksysProcess_GetState(process);
    // A Python that does not start counts as missing.
    status = state == vtksysProcess_State_Exited ? vtksysProcess_GetExitValue(process)
      : state == vtksysProcess_State_Error       ? NoMatplotlib
                                                 : -1;
    vtksysProcess_Delete(process);
  }
  if (status == NoMatplotlib)
  {
    std::cout << "charts: where python3 has matplotlib, bench/charts.py " << folder
              << " draws them\n";
  }
  else if (status != 0)
  {
    std::cerr << "relievo: bench: charts not drawn, status " << status << ": " << said;
  }
  return status == 0 || status == NoMatplotlib;
}
}
