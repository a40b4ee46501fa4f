# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reference's pages: the package's functions, and each wrapped class, from their docstrings."""

import inspect
import re
import textwrap

import relievo
from numpy.typing import ArrayLike
from relievo import _wrapped


def escaped(text):
    """Words of a docstring as reStructuredText: `code` as code, all else unchanged."""
    pieces = re.split(r"`([^`\s](?:[^`]*[^`\s])?)`", text)
    pieces[::2] = [re.sub(r"([\\*`|_])", r"\\\1", piece) for piece in pieces[::2]]
    # A backslash and a space end code that touches a letter, and are not shown.
    pieces[1::2] = [rf"\ ``{piece}``\ " for piece in pieces[1::2]]
    return "".join(pieces)


def paragraphs(text):
    """A plain docstring as reStructuredText: indented text, tables and lists as they are."""
    made = []
    for block in re.split(r"\n\s*\n", text.strip("\n")):
        lines = block.split("\n")
        if block.startswith("="):
            made.append(table(lines))
            continue
        plain = not block.startswith(" ") and not any(
            line.startswith((" ", "- ", "=")) for line in lines[1:])
        if plain:
            made.append(escaped(" ".join(line.strip() for line in lines)))
        else:
            made.append("::\n\n" + textwrap.indent(block, "   "))
    return "\n\n".join(made)


def table(lines):
    """A table with borders of '='; a row's cells are two spaces apart."""
    rows = [re.split(r"\s{2,}", line) for line in lines if not line.startswith("=")]
    text = ".. list-table::\n   :header-rows: 1\n\n"
    for row in rows:
        text += "".join(f"   {' ' if cell else '*'} - {escaped(words)}\n"
                        for cell, words in enumerate(row))
    return text


def entry(directive, signature, text):
    body = textwrap.indent(paragraphs(text), "   ") if text else ""
    return f".. py:{directive}:: {signature}\n\n{body}\n\n"


def heading(words, line):
    return f"{words}\n{line * len(words)}\n\n"


def functions():
    for name in sorted(dir(relievo)):
        what = getattr(relievo, name)
        if not name.startswith("_") and inspect.isfunction(what):
            yield name, what


def signature(what):
    """Parameters and result of a function, with the names of types that imports have."""
    members = inspect.formatannotation(ArrayLike).removeprefix("Union[").removesuffix("]")
    text = str(inspect.signature(what)).replace(members, "ArrayLike")
    return re.sub(r"\b(?:vtkmodules|relievo)(?:\.\w+)*\.(?=\w)", "", text)


def method(what):
    """Signatures and words of a wrapped method; between them stands the signature of C++."""
    signatures, words = [], []
    for block in re.split(r"\n\s*\n", (what.__doc__ or "").strip()):
        for line in block.split("\n"):
            if re.match(r"\w+\(.*\)( -> .*)?$", line) and not words:
                signatures.append(line)
            elif not line.startswith("C++: "):
                words.append(line)
        words.append("")
    seen = list(dict.fromkeys(re.sub(r"^(\w+)\(self(, )?", r"\1(", line) for line in signatures))
    return seen, "\n".join(words).strip("\n")


def lay_class(cls):
    words = re.sub(r"\A\w+ - |^Superclass: .*\n*", "", inspect.getdoc(cls), flags=re.M)
    # The page's list has the heading above the class.
    text = (f".. py:class:: {cls.__name__}({cls.__mro__[1].__name__})\n"
            "   :no-contents-entry:\n\n")
    text += textwrap.indent(paragraphs(words), "   ") + "\n\n"
    usual = ("NewInstance", "IsA", "IsTypeOf", "SafeDownCast", "GetNumberOfGenerationsFromBase",
             "GetNumberOfGenerationsFromBaseType")
    found = {name: method(what) for name, what in sorted(vars(cls).items())
             if not name.startswith("_") and name not in usual and inspect.ismethoddescriptor(what)}
    for name in list(found):
        # Without words of its own, a method stands with the one that sets its value.
        stem = re.fullmatch(r"Get(\w+?)(?:MinValue|MaxValue)?|(\w+)O(?:n|ff)", name)
        setter = stem and f"Set{stem[1] or stem[2]}"
        if setter in found and not found[name][1] and found[setter][1]:
            found[setter][0].extend(found.pop(name)[0])
    for signatures, words in found.values():
        if signatures:
            several = ("\n" + " " * len(".. py:method:: ")).join(signatures)
            text += textwrap.indent(entry("method", several, words), "   ")
    return text


# Characters of a module's classes on one page, of which Sphinx makes eight times as many. The
# classes of larger modules have pages of their own.
LONGEST = 24000


def modules():
    """Wrapped classes by their module, without the package's and the module's prefix."""
    found = {}
    for name in sorted(vars(_wrapped)):
        what = getattr(_wrapped, name)
        if inspect.isclass(what) and name.startswith("vtkRelievo"):
            module = what.__module__.rsplit(".", 1)[-1].removeprefix("vtkRelievo")
            found.setdefault(module, []).append(what)
    return found


def lay(dest):
    dest.mkdir()
    text = heading("Functions", "=") + ".. py:module:: relievo\n\n"
    text += paragraphs(inspect.getdoc(relievo)) + "\n\n"
    for name, what in functions():
        text += entry("function", f"{name}{signature(what)}", inspect.getdoc(what))
    (dest / "functions.rst").write_text(text)
    names = []
    for module, classes in sorted(modules().items()):
        text = heading(module, "=") + f"Classes of the module ``Relievo::{module}``.\n\n"
        laid = {cls.__name__: lay_class(cls) for cls in classes}
        if sum(map(len, laid.values())) > LONGEST:
            (dest / module).mkdir()
            for name, words in laid.items():
                (dest / module / f"{name}.rst").write_text(heading(name, "=") + words)
            listed = "".join(f"   {module}/{name}\n" for name in laid)
            text += f".. toctree::\n   :maxdepth: 1\n\n{listed}"
        else:
            text += "".join(heading(name, "-") + words for name, words in laid.items())
        (dest / f"{module}.rst").write_text(text)
        names.append(module)
    listed = "".join(f"   {name}\n" for name in ["functions", *names])
    (dest / "index.rst").write_text(
        heading("Classes and functions", "=")
        + "The functions of the package ``relievo``, and the classes that it wraps, which are "
        "those of C++.\n\n.. toctree::\n   :maxdepth: 2\n\n" + listed)
