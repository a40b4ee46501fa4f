# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The properties that ParaView must have, from the package's descriptions of values."""

import re

import relievo


def capitalize(name, between=""):
    """"depth_fade" as "DepthFade", or with a blank between the words."""
    words = re.split("[_-]", name)
    return between.join(word[:1].upper() + word[1:] for word in words)


# Choices that are not called by their names: those are the field's, for the command and Python.
LABELS = {"beer": "Exponential", "chord": "Linear"}


def is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def read(words, help_text):
    """A value as scripts of ParaView have it: 0.5, [1, 1], 1 for on, "Reinhard Rgb"."""
    if help_text.endswith(" Takes on or off."):
        return int(words == "on")
    parts = words.split(",")
    if all(is_number(part) for part in parts):
        numbers = [float(part) for part in parts]
        return numbers if len(numbers) > 1 else numbers[0]
    return LABELS.get(words, capitalize(words, " "))


def find_other(words, help_text):
    """Another value than that, as scripts of ParaView have it."""
    value = read(words, help_text)
    if help_text.endswith(" Takes on or off."):
        return 1 - value
    if isinstance(value, str):
        choices = re.search(r"one of (.*?)(, or the name .*)?\.$", help_text).group(1).split(", ")
        return read(choices[(choices.index(words) + 1) % len(choices)], help_text)
    if isinstance(value, list):
        return [number / 2 + 0.25 * i for i, number in enumerate(value, 1)]
    if "whole number" in help_text:
        return int(value // 2) or int(value) + 1
    return value / 2 or 1.0


def properties(owner, prefix, but=(), **ours):
    """
    Of an object that describes its values, without some; `ours` are ParaView's own defaults: name,
    (default, another).
    """
    found = {}
    for i in range(owner.GetNumberOfParameters()):
        name = owner.GetParameterName(i)
        if name not in but:
            words = ours.get(name, owner.GetParameterDefault(name))
            help_text = owner.GetParameterHelp(name)
            found[prefix + capitalize(name)] = (
                read(words, help_text), find_other(words, help_text))
    return found


def of_material():
    """Of each surface."""
    return properties(relievo.vtkRelievoMaterial(), "Relievo")


def of_view():
    """Properties of shadows, the environment, the selection and all stages of a view."""
    frame = relievo.vtkRelievoPass()
    found = {
        "RelievoShadowColored": (0, 1),
        **properties(frame.GetStage("shadows"), "RelievoShadow", ("colored_shadows",)),
        **properties(
            relievo.vtkRelievoEnvironment(), "RelievoEnvironment", up="z", gamma_correct="on"),
        **properties(
            relievo.vtkRelievoMarkers(), "RelievoMarkSelection", up="0,0,1", shape="glow"),
    }
    for i in range(frame.GetNumberOfStages()):
        stage = frame.GetStage(i)
        on = stage.GetEnabled()
        shown = (
            not on or stage.IsA("vtkRelievoPointStage") or stage.GetStageName() == "volumes")
        if stage.GetStageName() != "shadows" and shown:
            name = "RelievoStage" + capitalize(stage.GetStageName())
            found[name] = (int(on), 1 - int(on))
            found.update(properties(stage, name))
    return found
