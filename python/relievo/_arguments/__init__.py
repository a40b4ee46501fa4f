# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of all functions: renderers, data, arrays and parameters, and the errors for others."""
