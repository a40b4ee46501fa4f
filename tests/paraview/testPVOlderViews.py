# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views and surfaces older than the plugin get the properties of newer ones."""

import materialScene
import pv
from paraview import servermanager, simple

# A user's saved defaults of render views.
servermanager.vtkSMSettings.GetInstance().AddCollectionFromString(
    '{"views": {"RenderView": {"RelievoShadowMapSize": 512}},'
    ' "representations": {"GeometryRepresentation": {"RelievoHeightScale": 0.5}}}', 10.0)
OLDER = simple.CreateView("RenderView")
CHART = simple.CreateView("XYChartView")
OLDER.ViewSize = [300, 200]
simple.Show(simple.Sphere(), OLDER)
PLANE = simple.Plane(XResolution=1, YResolution=1)
OLDER_PLANE = simple.Show(PLANE, OLDER)
OLDER_GRID = simple.Show(simple.Wavelet(WholeExtent=[0, 1, 0, 1, 0, 1]), OLDER)
BEFORE = pv.picture(OLDER)
pv.load()
LATER = simple.CreateView("RenderView")
LATER_PLANE = simple.Show(PLANE, LATER)
LATER_GRID = simple.Show(simple.Wavelet(WholeExtent=[0, 1, 0, 1, 0, 1]), LATER)


def names(view):
    """Relievo's properties of a view."""
    return sorted(name for name in view.ListProperties() if name.startswith("Relievo"))


class OlderViews(pv.Test):
    def testProperties(self):
        """The same properties, in the same groups; none in views of other kinds."""
        self.assertIn("RelievoShadows", names(LATER))
        self.assertEqual(names(OLDER), names(LATER))
        self.assertEqual(names(CHART), [])

        def groups(view):
            proxy = view.SMProxy
            return [proxy.GetPropertyGroup(i).GetXMLLabel()
                    for i in range(proxy.GetNumberOfPropertyGroups())]

        self.assertIn("Shadows (Relievo)", groups(OLDER))
        self.assertEqual(groups(OLDER), groups(LATER))

    def testPicture(self):
        """Nothing changes until something is on, then it does; off again, it is as before."""
        self.same(pv.picture(OLDER), BEFORE, "all off")
        OLDER.RelievoSun = 1  # a Python attribute, though the class was made before the plugin came
        self.differ(pv.picture(OLDER), BEFORE, "sun")
        OLDER.RelievoSun = 0
        self.same(pv.picture(OLDER), BEFORE, "off again")

    def testDefaults(self):
        """The user's saved defaults of new views hold for these, too."""
        self.assertEqual(LATER.RelievoShadowMapSize, 512)
        self.assertEqual(OLDER.RelievoShadowMapSize, 512)
        self.assertEqual(OLDER.RelievoSunElevation, LATER.RelievoSunElevation)

    def testSurfaces(self):
        """The same of representations: properties, defaults, and that they work; gone again too."""
        self.assertIn("RelievoNormalMap", names(LATER_PLANE))
        self.assertEqual(names(OLDER_PLANE), names(LATER_PLANE))
        self.assertEqual(names(OLDER_GRID), names(LATER_GRID))
        self.assertEqual(OLDER_PLANE.RelievoHeightScale, 0.5)
        leaning = materialScene.write_normals("leaning.png", materialScene.lean(40))
        OLDER_PLANE.RelievoMaterial, OLDER_PLANE.RelievoNormalMap = 1, leaning
        self.differ(pv.picture(OLDER), BEFORE, "styled")
        OLDER_PLANE.RelievoMaterial = 0
        self.same(pv.picture(OLDER), BEFORE, "off again")

    def testOnce(self):
        """Loading another time changes nothing."""
        OLDER.RelievoShadowStrength = 0.5
        pv.load()
        self.assertEqual(OLDER.RelievoShadowStrength, 0.5)
        self.assertEqual(names(OLDER), names(LATER))
        OLDER.RelievoShadowStrength = 1.0


if __name__ == "__main__":
    pv.main()
