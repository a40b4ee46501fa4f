# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of stages, points, materials and environments as keywords of functions."""

import inspect
import textwrap

import numpy

from .errors import describe as described


def words(value):
    """A value as a text of parameters: "on", "0.5", "1,0.5,0", "warped"."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, numpy.bool_)):
        return "on" if value else "off"
    if hasattr(value, "hex_rgb"):  # PyVista's colours
        return value.hex_rgb
    if isinstance(value, (list, tuple, numpy.ndarray)) and numpy.ndim(value) == 1:
        return ",".join(words(each) for each in value)
    number = float(value)
    return str(int(number)) if number.is_integer() else repr(number)


def names(owner):
    """The parameters' names."""
    return [owner.GetParameterName(i) for i in range(owner.GetNumberOfParameters())]


def value(text):
    """The Python value of a parameter's text: "0.5", "on", "y"."""
    if text in ("on", "off"):
        return text == "on"
    try:
        number = float(text)
    except ValueError:
        return text
    return int(number) if number.is_integer() else number


def describe(owner, name, default=None, keyword=None):
    """The line of a docstring. keyword: the function's name for the parameter."""
    default = owner.GetParameterDefault(name) if default is None else default
    return f"{keyword or name}: {owner.GetParameterHelp(name)} Default {default}."


def describe_all(owner, keywords_of):
    """The lines of a docstring for parameters by keyword."""
    lines = [describe(owner, name, keyword=keyword) for keyword, name in keywords_of.items()]
    return "\n".join(textwrap.fill(line, 96, subsequent_indent="    ") for line in lines)


def keywords(defaults):
    """Parameters of a signature, from names and defaults."""
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    return [inspect.Parameter(name, kind, default=each) for name, each in defaults.items()]


def keywords_of(owner, renamed, without=()):
    """The names of the owner's parameters, by the keywords of a function."""
    return {renamed.get(name, name): name for name in names(owner) if name not in without}


def defaults_of(owner, named):
    """The default of each keyword of keywords_of()."""
    return {keyword: value(owner.GetParameterDefault(name)) for keyword, name in named.items()}


def bind(function, signature, arguments, given):
    """Binds arguments to a signature; a TypeError for mismatches names the function."""
    try:
        return signature.bind(*arguments, **given)
    except TypeError as error:
        raise TypeError(f"{function}() {error}") from None


def set_value(function, owner, name, given, keyword=None):
    """Sets a parameter; a ValueError for invalid values names the function. keyword: the function's
    name for the parameter."""
    keyword = keyword or name
    try:
        text = words(given)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(
            f"{function}: {keyword}: got {described(given)}, expected a number, numbers or a word"
        ) from None
    error = owner.TrySetParameter(name, text)
    if error:
        expected = error.partition(" given, ")[2]
        raise ValueError(f"{function}: {keyword}: got {described(given)}, {expected}")
