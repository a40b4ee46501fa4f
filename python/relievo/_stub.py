# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the package's stubs, for editors and type checkers, which run nothing: parameters of
functions and their help come from stages and filters, which describe them in C++; those of wrapped
classes from VTK's own generator, and with a VTK that the package includes its modules as well.

    python3 -m relievo._stub FOLDER
"""

import importlib
import inspect
import pathlib
import re
import sys
import tempfile
import types

from ._build import VTK
from ._vtkmodules import FOLDER

# The VTK's package, as a type checker finds it.
_VTK = "relievo.vtk" if (FOLDER / "vtk" / "__init__.py").is_file() else VTK


def _is_wrapped(thing):
    return isinstance(thing, type) and thing.__module__.startswith("relievo.vtkRelievo")


def _shown(module):
    """The name of a module, with that of VTK's package as a type checker finds it."""
    return re.sub(rf"^{VTK}\b", _VTK, module)


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
            self.imports.add(f"from {_shown(kind.__module__)} import {kind.__name__}{shown}")
        return name

    def function(self, name, function):
        signature = inspect.signature(function)
        parameters = signature.replace(return_annotation=inspect.Signature.empty)
        text = inspect.getdoc(function).replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
        end = "\n" if "\n" in text else ""
        lines = "".join(f"    {line}".rstrip() + "\n" for line in f'"""{text}{end}"""'.split("\n"))
        return f"def {name}{parameters} -> {self.type_of(signature.return_annotation)}:\n{lines}"


def make(package):
    """The package's own text: classes by the files that say more, and functions."""
    writer = _Writer(package)
    wrapped = (
        f"from {thing.__module__} import {name} as {name}"
        for name, thing in vars(package).items()
        if _is_wrapped(thing)
    )
    return "\n".join(["from typing import Any", "", *sorted({*writer.imports, *wrapped}), "",
                      "__version__: str", "", *writer.functions])  # fmt: skip


def _modules(package, folder):
    return {
        name: importlib.import_module(f"{package}.{name}")
        for name in sorted({path.name.split(".")[0] for path in folder.glob("vtk*.so")})
    }


def _wrapped_texts(modules, package, homes):
    """The text of each module by its name, from VTK's generator; classes by their full names."""
    with tempfile.TemporaryDirectory() as folder:
        from .vtk import generate_pyi

        generate_pyi.main(["generate_pyi", "-p", package, "-o", folder, *modules])
        texts = {name: pathlib.Path(folder, f"{name}.pyi").read_text("utf-8") for name in modules}

    for name, text in texts.items():
        own = set(re.findall(r"(?m)^class (\w+)", text))
        others = set()

        def place(match, own=own, others=others):
            kind = match[1]
            if kind in own or kind not in homes:
                return match[0]
            others.add(homes[kind])
            return f"'{homes[kind]}.{kind}'"

        text = text.replace("'getset_descriptor'", "Any")
        text = re.sub(r"'(vtk\w+)'", place, text)
        text = re.sub(rf"\b{VTK}\.(?=vtk)", f"{_VTK}.", text)
        at = text.index("\n\nimport ") if "\n\nimport " in text else text.index("\nclass ")
        others = sorted(others - set(re.findall(r"(?m)^import (\S+)", text)))
        texts[name] = text[:at] + "".join(f"\nimport {each}" for each in others) + text[at:]
    return texts


def write(package, folder):
    """Writes all stubs to a folder: __init__.pyi, and one for each wrapped module."""
    (folder / "__init__.pyi").write_text(make(package), encoding="utf-8")
    groups = [("relievo", _modules("relievo", FOLDER), folder)]
    if VTK != _VTK:
        groups.append((VTK, _modules(VTK, FOLDER / "vtk"), folder / "vtk"))
    homes = {
        name: _shown(thing.__module__)
        for module in list(sys.modules.values())
        for name, thing in vars(module).items()
        if isinstance(thing, type) and name.startswith("vtk")
        and getattr(module, "__name__", "").startswith(("relievo.vtk", f"{VTK}.vtk"))
    }  # fmt: skip
    for name, modules, to in groups:
        to.mkdir(exist_ok=True)
        for module, text in _wrapped_texts(modules, name, homes).items():
            (to / f"{module}.pyi").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(sys.modules["relievo"], pathlib.Path(sys.argv[1]))
