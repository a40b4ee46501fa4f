# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The import of the package: its VTK, its fonts, a browser without OpenGL, stubs."""
