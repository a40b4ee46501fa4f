# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a name can be a layer of what a renderer draws."""

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet

from .vtkRelievoLayers import vtkRelievoLayerCatalogue

_WITHOUT_LAYERS = ("vtkVolume", "vtkImageSlice", "vtkImageActor")


def why_not(name, renderer):
    """What is wrong with a layer's name, in words; None if nothing is, or nobody can know yet."""
    if not isinstance(name, str) or not name:
        return f"got {name!r}, expected a layer's name such as 'depth', or an array's"
    if vtkRelievoLayerCatalogue.GetIsLayer(name) or renderer is None:
        return None
    arrays = _arrays_of(renderer)
    if arrays is None or name.split(":", 1)[-1] in arrays or name in arrays:
        return None
    known = ", ".join(sorted(arrays)) or "none"
    return (
        f"got {name!r}, expected one of {vtkRelievoLayerCatalogue.GetLayerNames()}, or an array "
        f"of what the renderer draws ({known}); add the data that has it first"
    )


def _arrays_of(renderer):
    """Names of the arrays that the renderer's mappers are given; None where that is unknown."""
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
                        _add_arrays(mapper.GetInputDataObject(port, i), names)
            path = prop.GetNextPath()
    return names if mappers else None


def _add_arrays(data, names):
    if isinstance(data, vtkCompositeDataSet):
        blocks = data.NewIterator()
        blocks.InitTraversal()
        while not blocks.IsDoneWithTraversal():
            _add_arrays(blocks.GetCurrentDataObject(), names)
            blocks.GoToNextItem()
    elif isinstance(data, vtkDataSet):
        for attributes in (data.GetPointData(), data.GetCellData()):
            names.update(
                attributes.GetArrayName(i) or "" for i in range(attributes.GetNumberOfArrays())
            )
