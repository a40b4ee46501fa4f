# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of points with values."""


def polydata(points, **arrays):
    """The text of a .vtp with points and point arrays of floats."""
    lines = [
        '<VTKFile type="PolyData" version="1.0"><PolyData>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0" '
        'NumberOfStrips="0" NumberOfPolys="0"><PointData>'
    ]
    for name, (components, values) in arrays.items():
        lines.append(
            f'<DataArray type="Float64" Name="{name}" NumberOfComponents="{components}" '
            f'format="ascii">{" ".join(map(str, values))}</DataArray>'
        )
    places = " ".join(str(value) for point in points for value in point)
    lines.append(
        '</PointData><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
        f"{places}</DataArray></Points></Piece></PolyData></VTKFile>"
    )
    return "\n".join(lines)
