# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks whether a name can be a layer of a renderer's data."""

from ..vtk.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet
from ..vtkRelievoLayers import vtkRelievoLayerCatalogue
from .data import did_you_mean

_WITHOUT_LAYERS = ("vtkVolume", "vtkImageSlice", "vtkImageActor")
_KINDS = ("point:", "cell:")


def why_not(name, renderer, shadows):
    """The problem of a layer's name; None if the name is valid, or cannot be checked yet.

    shadows: the vtkRelievoShadowStage that knows the names of the renderer's lights, or None.
    """
    if not isinstance(name, str) or not name:
        return f"got {name!r}, expected a layer's name such as 'depth', or an array's"
    if vtkRelievoLayerCatalogue.GetIsLayer(name) or renderer is None:
        return None
    lights = None
    if vtkRelievoLayerCatalogue.GetIsOfLight(name):
        if shadows is None:
            return None
        lights = [shadows.GetLightLayer(renderer, light) for light in renderer.GetLights()]
        if name in lights or not lights:
            return None
    arrays = _arrays_of(renderer)
    if arrays is None or name in arrays:
        return None
    if lights:
        return (
            f"got {name!r}, but no light has this name: the layers of the renderer's lights are "
            f"{', '.join(lights)}; add the light, or name it, first"
        )
    layers = vtkRelievoLayerCatalogue.GetLayerNames().split(", ")
    guess = did_you_mean(name, [*layers, *arrays])
    known = ", ".join(sorted(each for each in arrays if not each.startswith(_KINDS))) or "none"
    return (
        f"got {name!r}{guess}, expected one of {', '.join(layers)}, or an array of the "
        f"renderer's data ({known}); add the data that has it first"
    )


def _arrays_of(renderer):
    """Names of the arrays in the input of the renderer's mappers, with and without their kind; None
    if unknown."""
    names = set()
    mappers = 0
    for prop in renderer.GetViewProps():
        prop.InitPathTraversal()
        path = prop.GetNextPath()
        while path is not None:
            part = path.GetLastNode().GetViewProp()
            if not part.IsA("vtkActor"):
                if part.IsA("vtkProp3D") and not any(map(part.IsA, _WITHOUT_LAYERS)):
                    return None
            elif part.GetMapper() is not None:
                mapper = part.GetMapper()
                mappers += 1
                for port in range(mapper.GetNumberOfInputPorts()):
                    for i in range(mapper.GetNumberOfInputConnections(port)):
                        mapper.GetInputAlgorithm(port, i).Update()
                        if not add_arrays(mapper.GetInputDataObject(port, i), names):
                            return None
            path = prop.GetNextPath()
    return names if mappers else None


def add_arrays(data, names):
    """Adds the arrays' names, with and without their kind.

    Returns False for graphs, molecules and trees, which are converted to unknown data.
    """
    if isinstance(data, vtkCompositeDataSet):
        blocks = data.NewIterator()
        blocks.InitTraversal()
        while not blocks.IsDoneWithTraversal():
            if not add_arrays(blocks.GetCurrentDataObject(), names):
                return False
            blocks.GoToNextItem()
        return True
    if not isinstance(data, vtkDataSet):
        return False
    for kind, attributes in zip(_KINDS, (data.GetPointData(), data.GetCellData())):
        for i in range(attributes.GetNumberOfArrays()):
            name = attributes.GetArrayName(i) or ""
            names.update((name, kind + name))
    return True
