# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the sun stands: declination, direction, and the hours between sunrise and sunset.

The declination is that of the low-precision formulas for the sun in the Astronomical Almanac,
section C, right to 0.01 degrees from 1950 to 2050; it is taken at noon in Greenwich and moves by up
to 0.4 degrees a day. Direction and day length follow from it and the hour angle by spherical
trigonometry, as in J. A. Duffie and W. A. Beckman, Solar Engineering of Thermal Processes, section
1.6. Times are true solar time: the sun is highest at 12. (Clocks differ by the longitude within
their zone and by the equation of time.) Refraction, 0.6 degrees at the horizon, is left out.
"""

import datetime
import math


def declination(date):
    """Radians; date: a datetime.date."""
    days = (date - datetime.date(2000, 1, 1)).days
    anomaly = math.radians(357.528 + 0.9856003 * days)
    longitude = 280.460 + 0.9856474 * days
    longitude += 1.915 * math.sin(anomaly) + 0.020 * math.sin(2 * anomaly)
    tilt = math.radians(23.439 - 0.0000004 * days)
    return math.asin(math.sin(tilt) * math.sin(math.radians(longitude)))


def direction(latitude, date, hour):
    """The unit vector (east, north, up) towards the sun. latitude: degrees, north positive; hour:
    true solar time."""
    angle = math.radians(15 * (hour - 12))
    high, place = declination(date), math.radians(latitude)
    return (
        -math.cos(high) * math.sin(angle),
        math.sin(high) * math.cos(place) - math.cos(high) * math.sin(place) * math.cos(angle),
        math.sin(high) * math.sin(place) + math.cos(high) * math.cos(place) * math.cos(angle),
    )


def day_length(latitude, date):
    """Hours from sunrise to sunset, of the sun's middle at a flat horizon: 0 to 24."""
    cosine = -math.tan(math.radians(latitude)) * math.tan(declination(date))
    return 24 / math.pi * math.acos(min(1.0, max(-1.0, cosine)))
