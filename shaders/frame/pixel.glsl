// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Recognizes code that depends on the picture's pixels (a regular expression).
//RELIEVO::Section(Use)
gl_FragCoord\s*(\.\s*[xyrgst]|[^.\s])|vpDims
