# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers with the values under the cursor, as one page of HTML."""

import base64
import html
import json
import os
import pathlib
import zlib

import numpy

from .._arguments.errors import path_of
from .image import layer, layer_names
from .picture import picture_of, png_of

_PAGE = pathlib.Path(__file__).with_name("show.html")


class Page:
    """A page of layers, displayed by notebooks and saved by write()."""

    def __init__(self, text, rows):
        self._text, self._rows = text, rows

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the page, which needs no other file and no network."""
        with open(path_of(path, "path"), "w", encoding="utf-8") as file:
            file.write(self._text)

    def _repr_html_(self):
        return (
            f'<iframe srcdoc="{html.escape(self._text)}" title="Layers" loading="lazy" '
            f'style="width:100%;height:{self._rows + 130}px;border:0"></iframe>'
        )


def show(image, layers=None, path=None) -> Page:
    """Shows layers as a page with the values under the cursor, in a notebook or as a file.

        relievo.show(relievo.capture(renderer, ["depth", "normal"]))
        relievo.show(image, path="layers.html")

    image: vtkImageData from capture() or read_exr(). layers: names, or one; None for all.
    path: where to write the page; it needs no other file, and no network.

    Values are those of the layers, at single precision where they are double. The page grows with
    them: 1.2 MB per component of 640 x 480 pixels, before compression.

    Returns the page; a notebook shows it. Raises ValueError for a name that the image lacks.
    """
    layers = layer_names(image) if layers is None else layers
    names = [layers] if isinstance(layers, str) else list(layers)
    shown = []
    for name in names:
        values = layer(image, name)
        rgb, words = picture_of(name, values)
        whole = numpy.issubdtype(values.dtype, numpy.integer)
        kept = numpy.ascontiguousarray(values, numpy.int32 if whole else numpy.float32)
        shown.append({
            "name": name, "words": words, "columns": rgb.shape[1], "rows": rgb.shape[0],
            "components": kept.shape[2] if kept.ndim == 3 else 1, "whole": whole,
            "values": base64.b64encode(zlib.compress(kept.tobytes())).decode(),
            "picture": base64.b64encode(png_of(rgb)).decode(),
        })  # fmt: skip
    if not shown:
        raise ValueError("show: got no layers, expected one or more")
    data = json.dumps(shown).replace("<", "\\u003c")  # so that no tag ends the script
    text = _PAGE.read_text(encoding="utf-8").replace("@LAYERS@", data)
    page = Page(text, shown[0]["rows"])
    if path is not None:
        page.write(path)
    return page
