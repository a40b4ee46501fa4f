# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layers that there are."""

import math

from .vtkRelievoLayers import vtkRelievoLayerCatalogue


def layers():
    """The layers that there are: a dict of their names, each with a dict of what it is.

    help: one line. type: "float", "double", "int" or "unsigned char". components: values per
    pixel. background: the value where nothing is; None for color, whose background is the
    renderer's. "shadow_N" stands for the layers of all lights. Point and cell arrays of what is
    drawn are layers too, by their own names.

        relievo.layers()["depth"]["help"]
    """
    table = vtkRelievoLayerCatalogue
    found = {}
    for i in range(table.GetNumberOfLayers()):
        background = table.GetLayerBackground(i)
        found[table.GetLayerName(i)] = {
            "help": table.GetLayerHelp(i),
            "type": table.GetLayerType(i),
            "components": table.GetLayerComponents(i),
            "background": None if math.isnan(background) else background,
        }
    return found
