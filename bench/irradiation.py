# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error and cost of irradiation, against closed forms and pvlib.

    python bench/irradiation.py [--small] [--rounds N] >irradiation.csv

Needs the package relievo in PYTHONPATH, and numpy; with pvlib (0.16 was tried) and pandas also the
rows of planes. Scenes:

- courtyard, canyon: the floor of a courtyard twice as wide as high, whose walls share their edges
  or are separate, and of a long canyon twice as wide as high, under a uniform sky, whose share at
  each place has a closed form. By relievo's `tolerance`, with bounds, and by `sky`, a number of
  rays without bounds.
- canyon, sun: the same floor under the sun of a day of 500 W/m2. The truth has the sun of every two
  seconds, and no rays.
- a plane, by name: a year at Vienna without clouds, by skies that are uniform or by Perez. The
  truth is pvlib's, in steps of five minutes.

Columns: kWh/m2 in the mean of all places (of `sky`, the share of the sky); the largest error, the
rms error and the largest bound, in percent of each place's value; processor milliseconds of all
threads, the least of the rounds (3). --small measures small scenes, in seconds. Exit status: 0.
"""

import argparse
import csv
import sys

import numpy
import relievo
from relievo.vtk.util.numpy_support import vtk_to_numpy
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from scaling_out import seconds

COLUMNS = ("scene", "method", "setting", "places", "kWh/m2", "largest error %", "rms error %",
           "largest bound %", "processor milliseconds")  # fmt: skip
TOLERANCES = (10, 5, 2, 1, 0.5, 0.2)
SAMPLES = (16, 64, 256, 1024, 4096)
DAY = {"latitude": 40.0, "longitude": 0.0, "first": "2026-06-21", "time_zone": 0, "up": "z"}
YEAR = {"latitude": 48.2, "longitude": 16.4, "first": "2026-01-01", "last": "2026-12-31", "up": "z"}
SKY = {"dhi": numpy.full(24, 100.0), "dni": numpy.zeros(24)}
SUN = {"dhi": numpy.zeros(24), "dni": numpy.full(24, 500.0)}
# Tilt and azimuth, both in degrees.
PLANES = {"level": (0, 180), "tilted to the south": (35, 180), "south wall": (90, 180),
          "east wall": (90, 90), "north wall": (90, 0)}  # fmt: skip


def plate(corner, first, second, side=1):
    made = vtkPlaneSource()
    made.SetOrigin(corner)
    made.SetPoint1(first)
    made.SetPoint2(second)
    made.SetResolution(side, side)
    made.Update()
    return made.GetOutput()


def middles(side):
    """Of the cells across the floor, from -1 to 1."""
    return (2 * numpy.arange(side) + 1) / side - 1


def courtyard(side, merged=True):
    """The floor, its walls, and the share of the sky at each cell."""
    corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    floor = plate(corners[0], corners[1], corners[3], side)
    walls = [plate(each, corners[(i + 1) % 4], (*each[:2], 1)) for i, each in enumerate(corners)]
    if merged:  # walls that share their edges
        joined = vtkAppendPolyData()
        for wall in walls:
            joined.AddInputData(wall)
        merge = vtkCleanPolyData()
        merge.SetInputConnection(joined.GetOutputPort())
        merge.Update()
        walls = merge.GetOutput()
    x, y = numpy.meshgrid(middles(side), middles(side))
    share = 0
    for a in (1 - x, 1 + x):
        for b in (1 - y, 1 + y):  # a rectangle with one corner vertically above
            over_a, over_b = numpy.sqrt(1 + a * a), numpy.sqrt(1 + b * b)
            share += (a / over_a * numpy.arctan(b / over_a)
                      + b / over_b * numpy.arctan(a / over_b)) / (2 * numpy.pi)  # fmt: skip
    return floor, walls, share.ravel()


def canyon(side):
    """It leads north."""
    floor = plate((-1, -1, 0), (1, -1, 0), (-1, 1, 0), side)
    walls = [plate((x, -5000, 0), (x, 5000, 0), (x, -5000, 1)) for x in (-1, 1)]
    x = middles(side)
    share = 0.5 * sum(each / numpy.sqrt(1 + each * each) for each in (1 - x, 1 + x))
    return floor, walls, numpy.tile(share, side)


def sun_in_canyon(side):
    """kWh/m2 of 500 W/m2 at each cell."""
    sun = relievo.vtkRelievoSolarPosition()
    sun.SetLatitude(DAY["latitude"])
    sun.SetDate(2026, 6, 21)
    steps, x, hours, toward = 43200, middles(side), 0, [0.0] * 3
    for step in range(steps):
        sun.SetHour(24 * (step + 0.5) / steps)
        sun.GetDirection(toward)
        east, _, up = toward
        if up > 0:
            hours = hours + 24 / steps * up * (numpy.abs(x + east / up) < 1)
    return numpy.tile(0.5 * hours, side)


class Rows:
    def __init__(self, rounds):
        self.rounds = rounds
        self.out = csv.writer(sys.stdout, lineterminator="\n")
        self.out.writerow(COLUMNS)

    def write(self, scene, method, setting, truth, found, bound, taken):
        """A row; found and truth in kWh/m2 of each place."""
        error = 100 * numpy.abs(found - truth) / truth
        self.out.writerow([
            scene, method, setting, len(truth), f"{found.mean():.5g}", f"{error.max():.3g}",
            f"{numpy.sqrt((error**2).mean()):.3g}",
            "" if bound is None else f"{100 * (bound / found).max():.3g}", f"{1000 * taken:.3g}",
        ])  # fmt: skip
        sys.stdout.flush()

    def measure(self, scene, method, setting, truth, mesh, **given):
        """sun_exposure() of a mesh; truth: a function of open level ground's kWh/m2."""
        done = []
        taken = seconds(lambda: done.append(relievo.sun_exposure(mesh, **given)), self.rounds)
        arrays = done[-1].GetCellData()
        whole = done[-1].GetFieldData().GetArray("open_irradiation")
        if "sky" in given:
            found, bound = vtk_to_numpy(arrays.GetArray("sky_view")).astype(float), None
        else:
            found, bound = (vtk_to_numpy(arrays.GetArray(name)).astype(float)
                            for name in ("irradiation", "irradiation_bound"))  # fmt: skip
        self.write(scene, method, setting, truth(whole.GetValue(0) if whole else 1), found, bound,
                   taken)  # fmt: skip


def skies(rows, side, tolerances, samples):
    for scene, (floor, walls, share) in (
        ("courtyard", courtyard(side)),
        ("courtyard, separate walls", courtyard(side, merged=False)),
        ("canyon", canyon(side)),
    ):  # fmt: skip
        for tolerance in tolerances:
            rows.measure(scene, "tolerance", tolerance, lambda open_, share=share: open_ * share,
                         floor, **DAY, occluders=walls, irradiance="isotropic", weather=SKY,
                         tolerance=tolerance, albedo=0, step=60)  # fmt: skip
        for number in samples:  # a single step of the sun while rays into the sky are timed
            rows.measure(scene, "number of rays", number, lambda _, share=share: share, floor,
                         **DAY, occluders=walls, sky=number, step=240)  # fmt: skip


def suns(rows, side, tolerances):
    floor, walls, _ = canyon(side)
    truth = sun_in_canyon(side)
    for tolerance in tolerances:
        rows.measure("canyon, sun", "tolerance", tolerance, lambda _: truth, floor, **DAY,
                     occluders=walls, irradiance="isotropic", weather=SUN, tolerance=tolerance,
                     albedo=0, step=2)  # fmt: skip


def by_pvlib(tilt, azimuth, sky, minutes):
    """kWh/m2 of the year."""
    import pandas
    import pvlib

    start = pandas.Timestamp(YEAR["first"], tz="UTC") - pandas.Timedelta(hours=16.4 / 15)
    times = pandas.date_range(start, periods=365 * 1440 // minutes, freq=f"{minutes}min")
    times += pandas.Timedelta(minutes=minutes / 2)
    sun = pvlib.solarposition.get_solarposition(times, YEAR["latitude"], YEAR["longitude"])
    zenith = sun["zenith"]
    mass = pvlib.atmosphere.get_relative_airmass(zenith, model="kastenyoung1989")
    outside = pvlib.irradiance.get_extra_radiation(times, 1361, method="spencer")
    clear = pvlib.clearsky.ineichen(zenith, mass, 3, dni_extra=outside)
    if sky == "perez":
        diffuse = pvlib.irradiance.perez(tilt, azimuth, clear["dhi"], clear["dni"], outside, zenith,
                                         sun["azimuth"], mass)  # fmt: skip
    else:
        diffuse = pvlib.irradiance.isotropic(tilt, clear["dhi"])
    cosine = pvlib.irradiance.aoi_projection(tilt, azimuth, zenith, sun["azimuth"])
    direct = clear["dni"] * numpy.maximum(cosine, 0)
    ground = pvlib.irradiance.get_ground_diffuse(tilt, clear["ghi"], 0.2)
    return float(numpy.nansum(direct + diffuse + ground)) * minutes / 60000


def planes(rows, minutes):
    try:
        import pvlib  # noqa: F401
    except ImportError:
        print("irradiation: without pvlib, no rows of planes", file=sys.stderr)
        return
    for name, (tilt, azimuth) in PLANES.items():
        lean, turn = numpy.radians([tilt, azimuth])
        along = numpy.array((-numpy.cos(turn), numpy.sin(turn), 0))  # level
        up = numpy.array((-numpy.sin(turn) * numpy.cos(lean), -numpy.cos(turn) * numpy.cos(lean),
                          numpy.sin(lean)))  # fmt: skip
        mesh = plate((0, 0, 0), along, up)
        for sky in ("isotropic", "perez"):
            truth = []
            taken = seconds(lambda t=tilt, a=azimuth, s=sky, to=truth:
                            to.append(by_pvlib(t, a, s, minutes)), rows.rounds)  # fmt: skip
            of_pvlib = numpy.array(truth[-1:])
            scene = f"{name}, {sky}"
            rows.write(scene, "pvlib", f"{minutes} minutes", of_pvlib, of_pvlib, None, taken)
            rows.measure(scene, "tolerance", 1, lambda _, truth=of_pvlib: truth, mesh, **YEAR,
                         irradiance=sky)  # fmt: skip


def main():
    given = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    given.add_argument("--small", action="store_true")
    given.add_argument("--rounds", type=int, default=3)
    given = given.parse_args()
    rows = Rows(given.rounds)
    side = 8 if given.small else 48
    skies(rows, side, (5, 1) if given.small else TOLERANCES,
          (16, 1024) if given.small else SAMPLES)  # fmt: skip
    suns(rows, side, (1,) if given.small else (5, 1, 0.5))
    planes(rows, 60 if given.small else 5)


if __name__ == "__main__":
    main()
