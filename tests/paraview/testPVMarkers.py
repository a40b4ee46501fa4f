# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of a representation as markers, and markers of the selection: positions, properties.
Several ranks: testPVLamps."""

import lampScene
import numpy
import pv
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

# Every property of a representation: default, another value as a script gives it.
PROPERTIES = {
    "RelievoMarkers": (0, 1),
    "RelievoMarkersShape": ("Ring", "Disc"),
    "RelievoMarkersRadius": (1.0, 2.0),
    "RelievoMarkersRadiusArray": ("radius", ""),
    "RelievoMarkersWidth": (0.2, 0.5),
    "RelievoMarkersWidthArray": ("width", ""),
    "RelievoMarkersReach": (4.0, 2.5),
    "RelievoMarkersReachArray": ("reach", ""),
    "RelievoMarkersUp": ([0.0, 0.0, 1.0], [0.0, 0.5, 1.0]),
    "RelievoMarkersOpacity": (0.8, 0.3),
    "RelievoMarkersOpacityArray": ("opacity", ""),
    "RelievoMarkersColor": ([1.0, 0.5, 0.0], [0.0, 0.5, 1.0]),
    "RelievoMarkersColorArray": ("color", ""),
}


class Markers(lampScene.Test):
    def check(self, places, radii, opacity, what):
        """Discs: within the radius of any of the places, and nowhere else, but for the edges."""
        marked, place, depth = self.layers("marker", "position", "depth")
        there = numpy.isfinite(depth)
        left = [radius - numpy.linalg.norm(place[there] - point, axis=-1)
                for point, radius in zip(places, radii)]  # fmt: skip
        inside = numpy.max(left, axis=0)
        self.assertGreater((inside > 0.1).sum(), 50, what)
        self.assertGreater(marked[there][inside > 0.1].min(), opacity - 1e-5, what)
        self.assertFalse(marked[there][inside < -0.2].any(), what)
        self.assertFalse(marked[~there].any(), what)

    def test_points(self):
        """Discs on floor and ball, wherever the representation is moved."""
        self.shown.RelievoMarkers, self.shown.RelievoMarkersShape = 1, "Disc"
        for move in ((0, 0, 0), (0.3, 0.2, 0.1)):
            setattr(self.shown, pv.TRANSLATION, list(move))
            self.check(numpy.array(lampScene.PLACES) + move, lampScene.RADII, 0.8, move)

    def test_shadow(self):
        """Dark below the points, as their height says."""
        self.shown.RelievoMarkers, self.shown.RelievoMarkersShape = 1, "Shadow"
        self.shown.RelievoMarkersOpacity = 1.0
        self.scene.ball.Visibility = 0
        marked, place, depth = self.layers("marker", "position", "depth")
        there = numpy.isfinite(depth)
        passes = numpy.ones(there.sum())
        for point, radius in zip(lampScene.PLACES, lampScene.RADII):
            away = numpy.linalg.norm(place[there][:, :2] - point[:2], axis=-1) / radius
            down = point[2] / radius
            passes *= 1 - (numpy.maximum(0, 1 - away**2) ** 2 * (1 - down / 4) *
                           numpy.minimum(1, 4 * down))  # fmt: skip
        self.assertLess(passes.min(), 0.2)
        numpy.testing.assert_allclose(marked[there], 1 - passes, rtol=0, atol=1e-4)

    def test_properties(self):
        """Defaults, and pictures that change and come back."""
        defaults = {name: first for name, (first, _) in PROPERTIES.items()}
        self.assertEqual(pv.values(self.shown, PROPERTIES), defaults)
        off = pv.picture(self.view)
        self.shown.RelievoMarkers = 1
        on = pv.picture(self.view)
        self.differ(off, on, "markers", share=0.02)
        for name, (default, other) in PROPERTIES.items():
            if name == "RelievoMarkers":
                continue
            setattr(self.shown, name, other)
            # Only the array `radius` exists; and these are rings.
            changes = not name.endswith(("Radius", "Reach", "Up")) and (
                not name.endswith("Array") or name.endswith("RadiusArray"))  # fmt: skip
            changed = pv.picture(self.view)
            (self.differ if changes else self.same)(on, changed, name)
            setattr(self.shown, name, default)
        self.same(on, pv.picture(self.view), "as before")
        self.shown.Visibility = 0
        self.same(off, pv.picture(self.view), "hidden")
        self.shown.Visibility = 1
        self.view.RelievoStageMarkers = 0
        self.same(off, pv.picture(self.view), "switched off in the view")

    def test_selection(self):
        """The selection is marked, of any kind and while it moves, as long as that is on."""
        self.scene.ball.Visibility = 0
        floor = self.scene.floor
        off = pv.picture(self.view)
        self.view.RelievoMarkSelection, self.view.RelievoMarkSelectionShape = 1, "Disc"
        self.view.RelievoMarkSelectionRadius = 0.4
        self.same(off, pv.picture(self.view), "nothing is selected")
        plane = simple.FindSource("Plane1")
        points = vtk_to_numpy(simple.FetchData(plane)[0].GetPoints().GetData()).astype(float)
        simple.SelectIDs(IDs=[0, 20, 0, 42], FieldType="POINT", Source=plane)
        marked = pv.picture(self.view)
        self.differ(off, marked, "points", share=0.03)
        self.check(points[[20, 42]], [0.4, 0.4], 0.8, "points")
        setattr(floor, pv.TRANSLATION, [0.5, 0.3, 0.2])
        self.check(points[[20, 42]] + (0.5, 0.3, 0.2), [0.4, 0.4], 0.8, "moved")
        setattr(floor, pv.TRANSLATION, [0, 0, 0])
        self.view.RelievoMarkSelectionColor = [0.0, 1.0, 0.0]
        self.differ(marked, pv.picture(self.view), "colour", share=0.02)
        self.view.RelievoMarkSelectionColor = [1.0, 0.5, 0.0]
        self.same(marked, pv.picture(self.view), "as before")
        simple.ClearSelection(plane)
        self.same(off, pv.picture(self.view), "nothing is selected any more")
        simple.SelectIDs(IDs=[0, 27], FieldType="CELL", Source=plane)
        cell = simple.FetchData(plane)[0].GetCell(27).GetPointIds()
        corners = [cell.GetId(i) for i in range(4)]
        self.check(points[corners], [0.4] * 4, 0.8, "a cell")
        self.view.RelievoMarkSelection = 0
        marked, = self.layers("marker")
        self.assertFalse(marked.any(), "off")


if __name__ == "__main__":
    pv.main()
