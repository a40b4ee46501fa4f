# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mapper that draws its input in four pieces."""

from parts import actor, cone, mapper_of, plane, show, sphere

pieces = mapper_of(sphere(resolution=24))
pieces.SetNumberOfSubPieces(4)
window = show(actor(pieces, (0.9, 0.6, 0.3)), actor(cone(at=(1.3, 0, 0))), actor(plane()))

each = [mapper_of(sphere(resolution=24)) for _ in range(4)]
for piece, mapper in enumerate(each):
    mapper.SetNumberOfPieces(4)
    mapper.SetPiece(piece)
parts = [actor(mapper, (0.9, 0.6, 0.3)) for mapper in each]
twin = show(*parts, actor(cone(at=(1.3, 0, 0))), actor(plane()))
