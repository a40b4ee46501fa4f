# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Locales that change what readers could take for numbers and letters: a comma for the decimal
point, and in Turkish no I for i. Made where they are needed: a system has those of its users."""

import os
import subprocess

NAMES = ("de_DE.UTF-8", "tr_TR.UTF-8")
CATEGORIES = ("CTYPE", "NUMERIC", "MONETARY", "TIME", "MESSAGES", "PAPER", "NAME", "ADDRESS",
              "TELEPHONE", "MEASUREMENT", "IDENTIFICATION", "COLLATE")  # fmt: skip


def make(folder):
    """Makes them in the folder, where this process and its children find them from then on. The
    order of words, which takes most of the time to make and which nothing here asks for, is C's."""
    os.environ["LOCPATH"] = str(folder)
    for name in NAMES:
        source, own = f"{folder}/{name}.source", name.split(".")[0]
        with open(source, "w", encoding="utf-8") as file:
            for each in CATEGORIES:
                of = "POSIX" if each == "COLLATE" else own
                file.write(f'LC_{each}\ncopy "{of}"\nEND LC_{each}\n')
        subprocess.run(["localedef", "-i", source, "-f", "UTF-8", f"{folder}/{name}"], check=True)
