# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Locales that change how readers might parse numbers and letters: a comma as the decimal point,
and in Turkish no I for i. Generated, because a system has only those of its users."""

import os
import subprocess

NAMES = ("de_DE.UTF-8", "tr_TR.UTF-8")
CATEGORIES = ("CTYPE", "NUMERIC", "MONETARY", "TIME", "MESSAGES", "PAPER", "NAME", "ADDRESS",
              "TELEPHONE", "MEASUREMENT", "IDENTIFICATION", "COLLATE")  # fmt: skip


def make(folder):
    """Makes the locales in the folder and registers it for this process and its children. The
    collation
    order, which takes most of the time and is not needed here, is that of C."""
    os.environ["LOCPATH"] = str(folder)
    for name in NAMES:
        source, own = f"{folder}/{name}.source", name.split(".")[0]
        with open(source, "w", encoding="utf-8") as file:
            for each in CATEGORIES:
                of = "POSIX" if each == "COLLATE" else own
                file.write(f'LC_{each}\ncopy "{of}"\nEND LC_{each}\n')
        subprocess.run(["localedef", "-i", source, "-f", "UTF-8", f"{folder}/{name}"], check=True)
