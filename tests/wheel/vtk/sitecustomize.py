# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""For tests, which are written for every VTK: `vtkmodules` is the package of the wheel's VTK."""

import importlib
import importlib.abc
import importlib.util
import sys


class Alias(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds each module of `vtkmodules` as the one of `cvista`, loaded once."""

    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] == "vtkmodules":
            return importlib.util.spec_from_loader(name, self)
        return None

    def create_module(self, spec):
        module = importlib.import_module(spec.name.replace("vtkmodules", "cvista", 1))
        spec.loader_state = module.__spec__
        return module

    def exec_module(self, module):
        module.__spec__ = module.__spec__.loader_state


sys.meta_path.insert(0, Alias())
