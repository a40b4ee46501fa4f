# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The curve of sRGB by its definition, IEC 61966-2-1: numbers or arrays from 0 to 1."""

import numpy


def encoded(light):
    """Values for display of light."""
    return numpy.where(light <= 0.0031308, 12.92 * light,
                       1.055 * numpy.maximum(light, 1e-9) ** (1 / 2.4) - 0.055)  # fmt: skip


def decoded(shown):
    """The light of values for display."""
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)
