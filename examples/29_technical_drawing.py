# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A machine part as a technical drawing: outlines and creases, hidden lines dashed.

    29_technical_drawing.py [FOLDER]

Default: the current folder. Writes to FOLDER
    drawing.png      a flange on a plate with five bores
"""

import math

import relievo
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkCellArray, vtkPolyData
from relievo.vtk.vtkFiltersGeneral import vtkContourTriangulator
from relievo.vtk.vtkFiltersModeling import vtkLinearExtrusionFilter
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import scene


def arc(center, radius, first, last, steps=72):
    """Points of an arc between two angles in degrees."""
    angles = [math.radians(first + (last - first) * i / steps) for i in range(steps)]
    return [
        (center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle))
        for angle in angles
    ]


def disc(radius):
    return arc((0, 0), radius, 0, 360)


def bore(x, y, radius):
    """A hole, with reversed orientation."""
    return arc((x, y), radius, 360, 0)


def plate(width, depth, radius):
    """A rectangle with round corners."""
    outline = []
    for x, y, first in ((1, 1, 0), (-1, 1, 90), (-1, -1, 180), (1, -1, 270)):
        corner = (x * (width / 2 - radius), y * (depth / 2 - radius))
        outline += arc(corner, radius, first, first + 90, 18)
    return outline


def extrude(loops, low, high):
    """An actor of the area within the loops, between two heights."""
    points, lines = vtkPoints(), vtkCellArray()
    for loop in loops:
        ids = [points.InsertNextPoint(x, y, low) for x, y in loop]
        lines.InsertNextCell(len(ids) + 1)
        for each in [*ids, ids[0]]:
            lines.InsertCellPoint(each)
    outline = vtkPolyData()
    outline.SetPoints(points)
    outline.SetLines(lines)
    filled = vtkContourTriangulator()
    filled.SetInputData(outline)
    body = vtkLinearExtrusionFilter()
    body.SetInputConnection(filled.GetOutputPort())
    body.SetExtrusionTypeToVectorExtrusion()
    body.SetVector(0, 0, high - low)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(body.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(0.86, 0.88, 0.92)
    look.SetAmbient(0.55)
    look.SetDiffuse(0.45)
    return actor


def main():
    picture = str(scene.folder() / "drawing.png")
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    bores = [bore(x, y, 0.22) for x in (-1.5, 1.5) for y in (-0.9, 0.9)]
    renderer.AddActor(extrude([plate(4, 2.8, 0.35), *bores, bore(0, 0, 0.55)], 0, 0.45))
    renderer.AddActor(extrude([disc(0.95), bore(0, 0, 0.55)], 0.45, 1.75))
    renderer.AddActor(extrude([disc(1.2), bore(0, 0, 0.75)], 1.75, 2.05))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(960, 600)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(4, -7, 5.2)
    camera.SetViewUp(0, 0, 1)
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    camera.Zoom(1.25)
    relievo.stage(renderer, "lines", width=2, hidden="dashed", dash=8)
    relievo.screenshot(renderer, picture)
    print(f"wrote {picture}")


if __name__ == "__main__":
    main()
