# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Locales that change what readers could take for numbers and letters: a comma for the decimal
point, and in Turkish no I for i. Made where they are needed: a system has those of its users."""

import os
import subprocess

NAMES = ("de_DE.UTF-8", "tr_TR.UTF-8")


def make(folder):
    """Makes them in the folder, where this process and its children find them from then on."""
    os.environ["LOCPATH"] = str(folder)
    for name in NAMES:
        subprocess.run(["localedef", "-i", name.split(".")[0], "-f", "UTF-8", f"{folder}/{name}"],
                       check=True)  # fmt: skip
