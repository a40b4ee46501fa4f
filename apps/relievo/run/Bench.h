// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Bench_h
#define Bench_h

namespace cli
{
struct BenchOptions;

/// `relievo bench`: what benches measure, and its charts. Throws UsageError for an unknown name.
/// Returns the exit status; a bench that fails has said why.
int Bench(const BenchOptions& options);
}

#endif
