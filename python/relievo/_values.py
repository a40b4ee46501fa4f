# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values that functions take."""

import numbers


def number(function, name, value, least=None, most=None):
    """A finite number within the range, as a float."""
    good = isinstance(value, numbers.Real) and abs(value) < float("inf")
    if not good or (least is not None and value < least) or (most is not None and value > most):
        within = "" if least is None else f" of {least} or more" if most is None else (
            f" from {least} to {most}")
        raise ValueError(f"{function}: {name}: got {value!r}, expected a number{within}")
    return float(value)
