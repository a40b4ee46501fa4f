# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A function for each stage that draws points: lamps(), fog(), markers()."""

import inspect

from .._arguments.arrays import add_arrays
from .._arguments.data import EXPECTED, cloud_of, data_of, did_you_mean
from .._arguments.errors import describe as described
from .._arguments.errors import is_a
from .._arguments.parameters import bind, describe, keywords, names, words
from .._arguments.renderers import need_renderer
from .._wrapped import vtkRelievoPass
from ..vtk.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput
from .keep import attach

# Examples beside the descriptions of values.
_EXAMPLES = {
    "fog": "relievo.fog(renderer, swamps, radius=30, density=0.05, color=(0.6, 0.7, 0.7))",
    "lamps": "relievo.lamps(renderer, street_lamps, radius=12, color=(1, 0.8, 0.5))",
    "markers": 'relievo.markers(renderer, [ship, buoy], shape="shadow", up=(0, 0, 1))',
}


def _set_points(made, name, points):
    """Connects points to data, to an algorithm, or to actors."""
    cloud = cloud_of(points)
    if cloud is not None:
        made.SetInputData(cloud)
        return
    several = isinstance(points, (list, tuple, set))
    props = list(points) if several else [points]
    is_props = all(is_a(each, "vtkProp3D") for each in props)
    if hasattr(made, "AddActor") and (several or is_props):
        if not props or not is_props:
            other = next((each for each in props if not is_a(each, "vtkProp3D")), points)
            raise ValueError(
                f"{name}: points: got {described(other)}, expected vtkProp3Ds, or points, n x 3"
            )
        for each in props:
            made.AddActor(each)
    elif isinstance(points, vtkAlgorithmOutput):
        made.SetInputConnection(points)
    elif isinstance(points, vtkAlgorithm) and points.GetNumberOfOutputPorts() > 0:
        made.SetInputConnection(points.GetOutputPort())
    else:
        data = data_of(points)
        if data is None:
            raise ValueError(f"{name}: points: got {described(points)}, expected points (n x 3), "
                             f"{EXPECTED}")
        made.SetInputData(data)


def _set_value(made, name, parameter, value):
    """Sets a parameter of the points from a number, numbers, a text or the name of an array."""
    arrays = _arrays(made)
    text = isinstance(value, str)
    is_switch = isinstance(value, bool) and made.IsPerPoint(parameter)
    error = ""
    try:
        said = words(value) if not is_switch else "always" if value else "never"
    except (TypeError, ValueError, OverflowError):
        said, error = "", f"got {described(value)}, expected a number, three numbers or a word"
    per_point = made.IsPerPoint(parameter)
    if text and said and per_point and (said in (arrays or ()) or _is_number(said)):
        made.SetArray(parameter, said)  # arrays may be named like numbers and colours
    elif not error:
        error = made.TrySetParameter(parameter, said)
        if not (error or text) and per_point and made.GetArray(parameter):
            error = f"got {described(value)}. {made.GetParameterHelp(parameter)}"
    array = made.GetArray(parameter) if per_point and not error else None
    if array and arrays is not None and array in arrays:
        error = _unlike(made, parameter, array)
    elif array and arrays is not None:
        known = ", ".join(sorted(arrays)) or "none"
        guess = did_you_mean(array, arrays)
        error = (f"got {value!r}{guess}, which is neither a value nor a point array; the points' "
                 f"arrays are {known}. {made.GetParameterHelp(parameter)}")
    if error:
        raise ValueError(f"{name}: {parameter}: {error}")


def _arrays(made):
    """Names of the current point arrays; None for actors, which have none, and before the points
    are made."""
    if made.GetNumberOfInputConnections(0) == 0:
        return None
    made.GetInputAlgorithm(0, 0).Update()
    found = set()
    if not add_arrays(made.GetInputDataObject(0, 0), found):
        return None
    return {each[len("point:"):] for each in found if each.startswith("point:")}


def _unlike(made, parameter, name):
    """The problem of an existing array, or ""."""
    data = made.GetInputDataObject(0, 0)
    array = data.GetPointData().GetAbstractArray(name) if is_a(data, "vtkDataSet") else None
    if array is None:
        return ""
    needed = made.GetParameterDefault(parameter).count(",") + 1
    if not array.IsA("vtkDataArray"):
        return f"got {name!r}, an array that holds no numbers"
    if array.GetNumberOfComponents() < needed:
        return (f"got {name!r}, an array of {array.GetNumberOfComponents()} components, expected "
                f"{needed}")
    return ""


def _is_number(words):
    try:
        float(words)
    except ValueError:
        return False
    return True


def _check_together(made, name, given):
    """Raises ValueError for arguments without an effect, except values of points."""
    for parameter, value in given.items():
        condition = "" if made.IsPerPoint(parameter) else made.GetParameterCondition(parameter)
        other, _, needed = condition.partition("=")
        if condition and made.GetParameter(other) != needed:
            raise ValueError(
                f"{name}: {parameter}: got {value!r}, expected {other}={needed!r} with it"
            )


def _describe(stage, made):
    """The docstring of a stage's function."""
    things = made.GetThings()
    lines = [
        f"Adds {things} to the renderer, one at each point.",
        "",
        f"    {_EXAMPLES.get(stage.GetStageName(), '')}",
        "",
        "renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter); the",
        "frame is attached if there is none. points: numbers of shape (n, 3); a vtkDataSet, a",
        "composite dataset, an object whose attribute `dataset` is one, or an algorithm or its",
        "output port, followed when it changes" + ("; or a" if hasattr(made, "AddActor") else "."),
    ]
    if hasattr(made, "AddActor"):
        lines += [
            "vtkProp3D, such as an actor, or several, followed as they move: distances are those",
            "from their boxes.",
        ]
    lines += [
        "",
        "A value is a number for all points, three for a colour or a direction, a colour's name or",
        '"#ff8000", or the name of a point array, which goes first; None takes the array of the',
        "value's name if the points have one, otherwise the default.",
        "",
    ]
    lines += [describe(made, parameter) for parameter in names(made)]
    for parameter in names(stage):
        lines.append(
            f"{parameter}: of all {things} of the renderer. {stage.GetParameterHelp(parameter)} "
            f"None leaves it; at first {stage.GetParameterDefault(parameter)}."
        )
    return "\n".join(lines) + (
        f"\n\nReturns the {made.GetClassName()}; attach(renderer).GetStage"
        f'("{stage.GetStageName()}").RemovePoints(it) takes it away.\n'
        "Raises ValueError for invalid arguments; then nothing is changed.\n"
    )


def _make(stage, made):
    """The function of a stage, with the parameters described by the stage and its points."""
    name = stage.GetStageName()
    of_points, of_stage = names(made), names(stage)
    signature = inspect.Signature(
        keywords(dict.fromkeys(("renderer", "points"), inspect.Parameter.empty))
        + keywords(dict.fromkeys(of_points + of_stage)),
        return_annotation=type(made),
    )

    def function(*arguments, **given):
        bound = bind(name, signature, arguments, given).arguments
        renderer = bound.pop("renderer")
        renderer = need_renderer(renderer)
        things = type(made)()
        _set_points(things, name, bound.pop("points"))
        given = {each: value for each, value in bound.items() if value is not None}
        values = {each: value for each, value in given.items() if each in of_points}
        for each, value in values.items():
            _set_value(things, name, each, value)
        _check_together(things, name, values)
        trial = vtkRelievoPass().GetStage(name)
        said = {}
        for each in given.keys() - values.keys():
            try:
                said[each] = words(given[each])
            except (TypeError, ValueError, OverflowError):
                raise ValueError(
                    f"{name}: {each}: got {described(given[each])}, expected a word"
                ) from None
            error = trial.TrySetParameter(each, said[each])
            if error:
                raise ValueError(f"{name}: {each}: {error.split(': ', 1)[-1]}")
        there = attach(renderer).GetStage(name)
        for each, text in said.items():
            there.SetParameter(each, text)
        there.AddPoints(things)
        return things

    function.__name__ = function.__qualname__ = name
    function.__module__ = __name__
    function.__signature__ = signature
    function.__doc__ = _describe(stage, made)
    return function


def functions():
    """The functions by name."""
    frame = vtkRelievoPass()
    stages = [frame.GetStage(i) for i in range(frame.GetNumberOfStages())]
    return {
        each.GetStageName(): _make(each, each.NewPoints())
        for each in stages
        if each.IsA("vtkRelievoPointStage")
    }
