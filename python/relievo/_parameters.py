# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters that stages, points, materials and environments describe, as keywords of functions."""

import inspect

import numpy

from ._errors import describe as described


def words(value):
    """A parameter's value in the words of descriptions: "on", "0.5", "1,0.5,0", "warped"."""
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
    """What a value's words say, as Python has it: "0.5", "on", "y"."""
    if text in ("on", "off"):
        return text == "on"
    try:
        number = float(text)
    except ValueError:
        return text
    return int(number) if number.is_integer() else number


def describe(owner, name, default=None):
    """The line of a docstring."""
    default = owner.GetParameterDefault(name) if default is None else default
    return f"{name}: {owner.GetParameterHelp(name)} Default {default}."


def keywords(defaults):
    """Parameters of a signature, by name with their defaults."""
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    return [inspect.Parameter(name, kind, default=each) for name, each in defaults.items()]


def bind(function, signature, arguments, given):
    """The arguments bound; TypeError that names the function for those that do not fit."""
    try:
        return signature.bind(*arguments, **given)
    except TypeError as error:
        raise TypeError(f"{function}() {error}") from None


def set_value(function, owner, name, given):
    """Sets a parameter; ValueError that names the function for what it does not take."""
    try:
        text = words(given)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(
            f"{function}: {name}: got {described(given)}, expected a number, numbers or a word"
        ) from None
    wrong = owner.TrySetParameter(name, text)
    if wrong:
        expected = wrong.partition(" given, ")[2]
        raise ValueError(f"{function}: {name}: got {described(given)}, {expected}")
