# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""For tests, which are written for every VTK: `vtkmodules` is the package of the wheel's VTK.

Without an import of relievo, which some of them time or check.
"""

import importlib.util
import runpy
import sys

package = importlib.util.find_spec("relievo").submodule_search_locations[0]
spec = importlib.util.spec_from_file_location(
    "relievo_vtkmodules", f"{package}/_package/vtkmodules.py"
)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
own = runpy.run_path(f"{package}/_build.py")["VTK"]
if own != "vtkmodules":
    sys.meta_path[:0] = [module.Included(own), module.Alias("vtkmodules", own)]
