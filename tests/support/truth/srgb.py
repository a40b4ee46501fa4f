# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sRGB curve by its definition, IEC 61966-2-1: numbers or arrays from 0 to 1."""

import numpy


def encoded(light):
    """Display values of light."""
    return numpy.where(light <= 0.0031308, 12.92 * light,
                       1.055 * numpy.maximum(light, 1e-9) ** (1 / 2.4) - 0.055)  # fmt: skip


def decoded(shown):
    """Light of display values."""
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)
