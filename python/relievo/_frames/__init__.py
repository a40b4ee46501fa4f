# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A renderer's frame: its pass, stages, environment, points to draw and scale bar."""
