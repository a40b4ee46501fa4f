# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the package's stub, for editors and type checkers, which run nothing: parameters of
functions and their help come from stages and filters, which describe them in C++.

    python3 -m relievo._stub FILE.pyi
"""

import inspect
import pathlib
import sys
import types


def _is_wrapped(thing):
    return isinstance(thing, type) and thing.__module__.startswith("relievo.vtk")


class _Writer:
    def __init__(self, package):
        self.functions, self.imports = [], set()
        things = {name: getattr(package, name) for name in package.__all__}
        self.public = {kind: name for name, kind in things.items() if inspect.isclass(kind)}
        for kind in self.public:
            self.type_of(kind)
        for name, thing in things.items():
            if inspect.isfunction(thing):
                self.functions.append(self.function(name, thing))

    def type_of(self, kind):
        """How the stub writes a class, a union of them, or None."""
        if isinstance(kind, types.UnionType):
            return " | ".join(map(self.type_of, kind.__args__))
        if kind is None:
            return "None"
        name = self.public.get(kind, kind.__name__)
        if kind.__module__ != "builtins" and not _is_wrapped(kind):
            shown = f" as {name}" if kind in self.public else ""
            self.imports.add(f"from {kind.__module__} import {kind.__name__}{shown}")
        return name

    def function(self, name, function):
        signature = inspect.signature(function)
        parameters = signature.replace(return_annotation=inspect.Signature.empty)
        text = inspect.getdoc(function).replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
        end = "\n" if "\n" in text else ""
        lines = "".join(f"    {line}".rstrip() + "\n" for line in f'"""{text}{end}"""'.split("\n"))
        return f"def {name}{parameters} -> {self.type_of(signature.return_annotation)}:\n{lines}"


def make(package):
    """The text: classes of Python by their files, which say more, and wrapped ones by name."""
    writer = _Writer(package)
    wrapped = sorted(name for name, thing in vars(package).items() if _is_wrapped(thing))
    return "\n".join(["from typing import Any", "", *sorted(writer.imports), "",
                      *(f"class {name}(Any): ..." for name in wrapped), "",
                      *writer.functions])  # fmt: skip


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(make(sys.modules["relievo"]), encoding="utf-8")
