# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hours of sun on the streets, walls and roofs of a town over a year, by rays.

    27_sunlight_of_a_year.py [FOLDER]

Default: the current folder. Writes to FOLDER
    sunlight.vtp    the town with the cell arrays sun_hours and insolation
    sunlight.png    hours of sun as colours, with a bar

Needs buildings.obj in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data puts it there.
"""

import time

import relievo
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from relievo.vtk.vtkIOXML import vtkXMLPolyDataWriter

import scene

VIENNA = (48.2, 16.4)
GROUND = 160  # squares of the ground each way
DAYS = 61  # interval of computed days; smaller is more accurate
MINUTES = 60  # between positions of the sun


def town():
    """The buildings and the ground beneath; z points up, north is y."""
    reader = relievo.vtkRelievoOBJReader()
    reader.SetFileName(scene.data("buildings.obj"))
    reader.Update()
    left, right, front, back, bottom, _ = reader.GetOutput().GetBounds()
    margin = 0.15 * (right - left)
    ground = vtkPlaneSource()
    ground.SetOrigin(left - margin, front - margin, bottom)
    ground.SetPoint1(right + margin, front - margin, bottom)
    ground.SetPoint2(left - margin, back + margin, bottom)
    ground.SetResolution(GROUND, GROUND)
    both = vtkAppendPolyData()
    both.AddInputConnection(reader.GetOutputPort())
    both.AddInputConnection(ground.GetOutputPort())
    both.Update()
    return both.GetOutput()


def main():
    folder = scene.folder()
    mesh = town()
    start = time.perf_counter()
    lit = relievo.sun_exposure(
        mesh, *VIENNA, "2026-01-01", "2026-12-31", every=DAYS, step=MINUTES, up="z"
    )
    took = time.perf_counter() - start
    open_ground = lit.GetFieldData().GetArray("possible_hours").GetValue(0)
    print(f"{lit.GetNumberOfCells()} cells in {took:.1f} s; open ground has {open_ground:.0f} "
          f"hours of sun in the year")
    data, picture = str(folder / "sunlight.vtp"), str(folder / "sunlight.png")
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()  # with newer expat, VTK 9.2 cannot read appended data
    writer.SetInputData(lit)
    writer.SetFileName(data)
    if not writer.Write():
        raise SystemExit(f"{data}: could not be written")
    relievo.scene(data, color_by="sun_hours", scalar_bar=True, up="z", size=(960, 600)).render(
        picture)
    print(f"wrote {data} and {picture}")


if __name__ == "__main__":
    main()
