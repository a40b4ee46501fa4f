# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras and rays: the pixels that see a place, and the places that see each other."""
