# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The position of the sun: declination, direction, and the hours between sunrise and sunset.

By relievo.vtkRelievoSolarPosition, exact to 0.01 degrees. Times are true solar time: the sun is
highest at 12. (Clocks differ by the longitude within their zone and by the equation of time; the
class also gives these.) Refraction, 0.6 degrees at the horizon, is ignored.
"""

import math

import relievo


def position(latitude, date, hour):
    """The sun over Greenwich's meridian. latitude: degrees, north positive; date: a datetime.date;
    hour: true solar time."""
    sun = relievo.vtkRelievoSolarPosition()
    sun.SetDate(date.year, date.month, date.day)
    sun.SetLatitude(latitude)
    sun.SetHour(sun.GetNoon() + hour - 12)
    return sun


def declination(date):
    """The sun's declination at noon, in radians; date: a datetime.date."""
    return math.radians(position(0.0, date, 12).GetDeclination())


def direction(latitude, date, hour):
    """The unit vector (east, north, up) towards the sun."""
    towards = [0.0, 0.0, 0.0]
    position(latitude, date, hour).GetDirection(towards)
    return tuple(towards)


def day_length(latitude, date):
    """Hours from sunrise to sunset, of the sun's middle at a flat horizon: 0 to 24."""
    return position(latitude, date, 12).GetDayLength()
