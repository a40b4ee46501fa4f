# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of layers and pictures: as numpy arrays, in files, on a page, as points."""
