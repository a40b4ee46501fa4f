# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""What lamps, fog and markers take: points with values, one for all or by point arrays."""

import math
import numbers

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput


def set_points(made, function, points):
    """Connects a vtkRelievoPointValues to data or to what makes it."""
    if isinstance(points, vtkAlgorithmOutput):
        made.SetInputConnection(points)
    elif isinstance(points, vtkAlgorithm) and points.GetNumberOfOutputPorts() > 0:
        made.SetInputConnection(points.GetOutputPort())
    else:
        kinds = ("vtkDataSet", "vtkCompositeDataSet")
        if not any(getattr(points, "IsA", lambda name: False)(kind) for kind in kinds):
            raise ValueError(f"{function}: points: got {points!r}, expected a vtkDataSet, a "
                             f"composite dataset, or an algorithm")
        made.SetInputData(points)


def set_value(made, function, name, value, set_for_all, least=None):
    """Sets a value from a number or the name of an array; None leaves it as it is."""
    if isinstance(value, str):
        made.SetArray(name, value)
    elif value is not None:
        good = isinstance(value, numbers.Real) and not math.isnan(value)
        if not good or (least is not None and value < least):
            expected = "a number" if least is None else f"a number of {least} or more"
            raise ValueError(f"{function}: {name}: got {value!r}, expected {expected}, or the name "
                             f"of a point array")
        set_for_all(float(value))
        made.SetArray(name, "")


def set_color(made, function, color):
    """Sets the colour from three numbers or the name of an array; None leaves it as it is."""
    if isinstance(color, str):
        made.SetArray("color", color)
    elif color is not None:
        made.SetColor(*three(function, "color", color))
        made.SetArray("color", "")


def number(function, name, value, least=None, most=None):
    """A finite number within the range, as a float."""
    good = isinstance(value, numbers.Real) and abs(value) < float("inf")
    if not good or (least is not None and value < least) or (most is not None and value > most):
        within = "" if least is None else f" of {least} or more" if most is None else (
            f" from {least} to {most}")
        raise ValueError(f"{function}: {name}: got {value!r}, expected a number{within}")
    return float(value)


def three(function, name, values):
    try:
        found = [float(each) for each in values]
    except (TypeError, ValueError):
        found = []
    if len(found) != 3 or any(map(math.isnan, found)):
        raise ValueError(f"{function}: {name}: got {values!r}, expected three numbers")
    return found
