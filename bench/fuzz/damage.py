# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damages files in ways relevant to readers, by a given random number generator."""

import re
import struct
import zlib

NUMBERS = (b"0", b"1", b"2", b"-1", b"3", b"255", b"65535", b"65536", b"2147483647", b"-2147483648",
           b"4294967295", b"4294967296", b"9223372036854775807", b"1000000000", b"1e308", b"-1e38",
           b"nan", b"inf", b"1e-320", b"0.5", b"99999999999999999999", b"x", b"")  # fmt: skip
INTEGERS = (0, 1, 2, 3, 0x7F, 0x80, 0xFF, 0x100, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000,
            0xFFFFFFFE, 0xFFFFFFFF, 30000, 1 << 28, 1 << 30)  # fmt: skip
TOKEN = re.compile(rb"[A-Za-z_#][\w#.:]*|[-+]?\d[\w.+-]*")
NUMBER = re.compile(rb"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")
NEST = ((b"<node>", b"</node>"), (b"<Piece>", b"</Piece>"), (b"[", b"]"), (b'{"a":', b"}"),
        (b"{", b"}"), (b"(", b")"))  # fmt: skip
HEADER = 300  # bytes that get half of the damage


def is_text(content):
    return b"\0" not in content[:4000]


def place(rng, content):
    end = len(content) if rng.random() < 0.5 else min(HEADER, len(content))
    return rng.randrange(max(1, end))


def bits(rng, content, _):
    for _ in range(rng.choice((1, 1, 3, 16))):
        at = place(rng, content)
        content[at] ^= 1 << rng.randrange(8)


def integer(rng, content, _):
    form = rng.choice(("<I", ">I", "<H", ">H", "<Q", ">Q"))
    size = struct.calcsize(form)
    at = place(rng, content)
    value = rng.choice(INTEGERS) & ((1 << 8 * size) - 1)
    content[at:at + size] = struct.pack(form, value)


def cut(rng, content, _):
    del content[place(rng, content):]


def lose(rng, content, _):
    at = place(rng, content)
    del content[at:at + rng.choice((1, 2, 8, 60, 1000))]


def double(rng, content, _):
    at = place(rng, content)
    stretch = content[at:at + rng.choice((1, 4, 60, 1000))]
    content[at:at] = stretch * rng.choice((1, 1, 1, 50))


def splice(rng, content, other):
    at, begin = place(rng, content), place(rng, other)
    end = len(other) if rng.random() < 0.5 else begin + rng.randrange(1, 200)
    content[at:len(content) if rng.random() < 0.5 else at] = other[begin:end]


def number(rng, content, other):
    found = list(NUMBER.finditer(bytes(content)))
    if not found:
        return integer(rng, content, other)
    match = rng.choice(found if rng.random() < 0.5 else found[:12])
    content[match.start():match.end()] = rng.choice(NUMBERS)


def token(rng, content, other):
    mine, its = list(TOKEN.finditer(bytes(content))), TOKEN.findall(other)
    if not mine or not its:
        return lose(rng, content, other)
    match = rng.choice(mine if rng.random() < 0.5 else mine[:20])
    content[match.start():match.end()] = rng.choice(its)


def lines(rng, content, _):
    rows = bytes(content).split(b"\n")
    a, b = rng.randrange(len(rows)), rng.randrange(len(rows))
    way = rng.randrange(3)
    if way == 0:
        rows[a], rows[b] = rows[b], rows[a]
    elif way == 1:
        rows.insert(a, rows[b])
    else:
        del rows[a]
    content[:] = b"\n".join(rows)


def nest(rng, content, _):
    before, after = rng.choice(NEST)
    depth = rng.choice((10, 1000, 100000))
    at = place(rng, content)
    content[at:at] = before * depth + after * (depth if rng.random() < 0.7 else 0)


OF_BYTES = (bits, bits, integer, integer, cut, lose, double, splice)
OF_TEXT = (number, number, number, token, token, lines, bits, cut, lose, double, splice, nest)


def png_sums(content):
    """A PNG with the correct checksums of its chunks."""
    out, at = content[:8], 8
    while at + 12 <= len(content):
        length = struct.unpack_from(">I", content, at)[0]
        if at + 12 + length > len(content):
            break
        body = content[at + 4:at + 8 + length]
        out += content[at:at + 4] + body + struct.pack(">I", zlib.crc32(body))
        at += 12 + length
    return out + content[at:]


def damage(rng, name, content, other):
    """A file's bytes with one to four kinds of damage. `other`: another file of its format."""
    made = bytearray(content)
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        made = made or bytearray(b"\n")
        rng.choice(OF_TEXT if is_text(made) else OF_BYTES)(rng, made, other or b"\n")
    made = bytes(made[:4 << 20])
    return png_sums(made) if name.endswith(".png") and rng.random() < 0.8 else made
