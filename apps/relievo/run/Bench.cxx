// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bench.h"

#include "Failure.h"
#include "Options.h"

#ifdef RELIEVO_HAVE_BENCH
#include "Display.h"
#include "RelievoBench.h"
#include "Values.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#endif

namespace cli
{
//------------------------------------------------------------------------------
int Bench(const BenchOptions& options)
{
#ifdef RELIEVO_HAVE_BENCH
  std::vector<std::string> names;
  for (const RelievoBenchEntry& entry : RelievoBenchEntries())
  {
    names.emplace_back(entry.Name);
  }
  if (options.Name.empty() && options.Redraw.empty())
  {
    throw WordsError("bench: no NAME given, expected one of " + Join(names, ", "));
  }
  if (!options.Name.empty() && std::find(names.begin(), names.end(), options.Name) == names.end())
  {
    RefuseValue("bench", options.Name, "one of " + Join(names, ", "));
  }
  vtkNew<vtkRenderWindow> probe; // the charts are drawn in windows that the bench makes itself
  CheckDisplay(probe);
  return options.Redraw.empty() ? RelievoBench(options.Name, options.Folder)
                                : RelievoBenchRedraw(options.Name, options.Redraw, options.Folder);
#else
  (void)options;
  throw WordsError("bench: this relievo was built without its benches (RELIEVO_BUILD_BENCH=OFF)");
#endif
}
}
