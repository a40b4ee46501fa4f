# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the package's stubs, for editors and type checkers, which run nothing: parameters of
functions and their help come from stages and filters, which describe them in C++; those of wrapped
classes from VTK's own generator. `relievo.vtk` has stubs of an included VTK's modules by that
generator; of any other VTK they only name its modules.

    python3 -m relievo._package.stub FOLDER
"""

import importlib
import inspect
import pathlib
import re
import sys
import tempfile
import types

from .._build import VTK
from .vtkmodules import FOLDER

# The VTK's package, as a type checker finds it.
_VTK = "relievo.vtk" if (FOLDER / "vtk" / "__init__.py").is_file() else VTK


_PATH = "str | os.PathLike[str]"
_SIZE = "Sequence[int] | None"

_HEAD = """import datetime
import os
from collections.abc import Callable, Sequence
from typing import Any

import numpy
from numpy.typing import ArrayLike
"""

_ANY = "from typing import Any\n\ndef __getattr__(name: str) -> Any: ...\n"

# The types of parameters by their names, which mean the same in most functions, or by function and
# name. Any: a renderer, a plotter, data or a filter. Others have the type of their default.
_PARAMETERS = {
    "K": "ArrayLike",
    "R": "ArrayLike | None",
    "a": "Any",
    "actors": "Sequence[Any]",
    "ambient": "dict[str, Any] | None",
    "area": "ArrayLike",
    "b": "Any",
    "before": "Moment",
    "camera": "CameraModel | None",
    "cameras": "Any",
    "compression": "str",
    "directory": _PATH,
    "far": "float | None",
    "files": _PATH,
    "first": "datetime.date | str",
    "fixed": "Sequence[Any]",
    "frame": "Any",
    "groups": "ArrayLike | str",
    "heights": f"ArrayLike | {_PATH}",
    "image": "Any",  # also PyVista's
    "irradiance": "bool | str",  # off
    "last": "datetime.date | str | None",
    "latitude": "float",
    "layers": "str | Sequence[str]",
    "length": "float | None",
    "lens": "CameraModel | str | None",
    "longitude": "float",
    "mesh": "Any",
    "name": "str",
    "names": "dict[Any, str] | None",
    "near": "float | None",
    "nodata": "float | None",
    "objects": "Any",
    "observers": "ArrayLike",
    "occluders": "Any",
    "options": "Any",
    "parameters": "Any",
    "path": _PATH,
    "pixel_types": "dict[str, str] | None",
    "point_ids": "str | None",
    "points": "Any",
    "previous": "Moment | None",
    "progress": "Callable[[float], Any] | None",
    "random": "numpy.random.Generator | int",
    "renderer": "Any",
    "size": _SIZE,
    "t": "ArrayLike | None",
    "target": "Any",
    "thing": "Any",
    "things": "Any",
    "time_zone": "float | None",
    "transform": "Sequence[float] | None",
    "unit": "str | None",
    "values": "ArrayLike | dict[str, ArrayLike]",
    "vary": "Callable[[int, numpy.random.Generator], dict[str, Any] | None] | None",
    "views": "tuple[int, int] | None",
    "weather": f"{_PATH} | dict[str, ArrayLike] | None",
    "words": _PATH,
    "camera.size": "Sequence[int]",
    "environment.path": "Any",
    "extrinsics.camera": "Any",
    "intrinsics.camera": "Any",
    "intrinsics.size": "Sequence[int]",
    "screenshot.path": f"{_PATH} | None",
    "show.layers": "str | Sequence[str] | None",
    "show.path": f"{_PATH} | None",
    "sun_exposure.points": "bool",
    "write_png.name": "str | None",
}  # fmt: skip

# Results of which the annotation says less.
_RESULTS = {
    "attributes": "dict[str, Any]",
    "extrinsics": "tuple[numpy.ndarray, numpy.ndarray]",
    "layer_names": "list[str]",
    "layers": "dict[str, dict[str, Any]]",
    "report": "dict[str, Any]",
    "visible": "Any",  # a mesh, a list of them, or with a cloud a pair of these
    "stages": "dict[str, dict[str, tuple[Any, str]]]",
}


def _is_wrapped(thing):
    return isinstance(thing, type) and thing.__module__.startswith("relievo.vtkRelievo")


def _shown(text):
    """A text with modules of VTK as a type checker finds them. Some classes of cvista for Python's
    stable ABI say that they are of vtkmodules."""
    return re.sub(rf"\b({VTK}|vtkmodules)\.(?=vtk)", f"{_VTK}.", text)


class _Writer:
    def __init__(self, package):
        self.functions, self.imports, self.renamed = [], set(), set()
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
            shown = f" as {name}" if name == kind.__name__ and kind in self.public else ""
            self.imports.add(f"from {_shown(kind.__module__)} import {kind.__name__}{shown}")
            if name != kind.__name__:
                self.renamed.add(f"{name} = {kind.__name__}")
        return name

    def function(self, name, function):
        signature = inspect.signature(function)
        parameters = self.parameters(name, signature.parameters.values())
        result = _RESULTS.get(name) or self.type_of(signature.return_annotation)
        text = inspect.getdoc(function).replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
        end = "\n" if "\n" in text else ""
        lines = "".join(f"    {line}".rstrip() + "\n" for line in f'"""{text}{end}"""'.split("\n"))
        return f"def {name}({parameters}) -> {result}:\n{lines}"

    def parameters(self, function, given):
        """How the stub writes parameters, with their types and defaults."""
        written, by_name = [], False
        for each in given:
            if each.kind is each.KEYWORD_ONLY and not by_name:
                written.append("*")
            by_name = each.kind in (each.KEYWORD_ONLY, each.VAR_POSITIONAL)
            known = _PARAMETERS.get(f"{function}.{each.name}") or _PARAMETERS.get(each.name)
            default = each.default
            plain = {bool: "bool", int: "float", float: "float", str: "str"}.get(type(default))
            kind = known or plain or "Any"
            stars = {each.VAR_POSITIONAL: "*", each.VAR_KEYWORD: "**"}.get(each.kind, "")
            end = "" if default is each.empty else f" = {default!r}"
            written.append(f"{stars}{each.name}: {kind}{end}")
        return ", ".join(written)


def make(package):
    """The package's own text: classes by the files that say more, and functions."""
    writer = _Writer(package)
    wrapped = (
        f"from {thing.__module__} import {name} as {name}"
        for name, thing in vars(package).items()
        if _is_wrapped(thing)
    )
    imports = sorted({*writer.imports, *wrapped})
    variables = [*writer.renamed, "__version__: str"]
    return "\n".join([_HEAD, *imports, "", *variables, "", *writer.functions])


def _modules(package, folder):
    return {
        name: importlib.import_module(f"{package}.{name}")
        for name in sorted({path.name.split(".")[0] for path in folder.glob("vtk*.so")})
    }


def _wrapped_texts(modules, package, homes):
    """The text of each module by its name, from VTK's generator; classes by their full names.
    Without the generator, which Debian's VTK 9.1 lacks, a module may have any name."""
    try:
        from ..vtk import generate_pyi
    except ImportError:
        return dict.fromkeys(modules, _ANY)
    with tempfile.TemporaryDirectory() as folder:
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
        text = re.sub(r"\b(Buffer|Callback|Pointer|Template)\b", r"_\1", text)  # not for import *
        text = re.sub(r"'(vtk\w+)'", place, text)
        text = _shown(text)
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
    if VTK == _VTK:
        for path, text in _aliases(VTK):
            (folder / "vtk" / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / "vtk" / path).write_text(text, encoding="utf-8")


def _aliases(package):
    """The files and texts of the stubs of `relievo.vtk`, which are the modules of a package."""
    root = pathlib.Path(*importlib.import_module(package).__path__)
    typed = (root / "py.typed").is_file()  # Debian's VTK has no stubs: any name may be in a module
    end = "" if typed else _ANY
    files = [*root.rglob("*.py"), *root.rglob("vtk*.so")]
    for path in sorted({each.relative_to(root).with_name(each.name.split(".")[0])
                        for each in files}):  # fmt: skip
        module = ".".join([package, *path.parts]).removesuffix(".__init__")
        yield path.with_suffix(".pyi"), f"from {module} import *\n{end}"


if __name__ == "__main__":
    write(sys.modules["relievo"], pathlib.Path(sys.argv[1]))
