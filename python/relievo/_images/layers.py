# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The catalogue of layers."""

from ..vtkRelievoLayers import vtkRelievoLayerCatalogue


def layers() -> dict:
    """Returns all layers: a dict by name, each value a dict that describes the layer.

    help: one line. type: "float", "double", "int" or "unsigned char". components: values per
    pixel. background: the value in the background (NaN for volume_value); None for color,
    whose background is the renderer's. "shadow_N" stands for the layers of all lights. Point and
    cell arrays of the visible data are layers too, by their own names.

        relievo.layers()["depth"]["help"]
    """
    table = vtkRelievoLayerCatalogue
    found = {}
    for i in range(table.GetNumberOfLayers()):
        name = table.GetLayerName(i)
        found[name] = {
            "help": table.GetLayerHelp(i),
            "type": table.GetLayerType(i),
            "components": table.GetLayerComponents(i),
            "background": None if name == "color" else table.GetLayerBackground(i),
        }
    return found
