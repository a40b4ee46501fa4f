// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Check.h
 * @brief Checks of a test: each failure is printed with its place and counted; the test goes on.
 *
 * A test program holds one relievoTest::Session (Session.h), checks, and returns its Result().
 */
#ifndef relievoTestCheck_h
#define relievoTestCheck_h

#include <string>

namespace relievoTest
{
/** Counts a failure and prints `FILE:LINE: failed: MESSAGE` to the standard error. */
void Fail(const char* file, int line, const std::string& message);

/** Number of failures so far in this process. */
int NumberOfFailures();

/** Forgets failures counted after the first `count`: for tests that prove that a check can fail. */
void ForgetFailuresAfter(int count);

/** Number of checks that `work` fails, forgotten again: for tests that prove a check can fail. */
template <typename Work>
int FailuresOf(Work work)
{
  const int before = NumberOfFailures();
  work();
  const int count = NumberOfFailures() - before;
  ForgetFailuresAfter(before);
  return count;
}

/** Fails unless `ok`; returns `ok`. */
bool Check(bool ok, const char* file, int line, const std::string& message);

/** Prints `what: value (limit LIMIT)`; fails unless value <= limit (NaN fails). */
bool CheckAtMost(double value, double limit, const char* file, int line, const std::string& what);

/** Fails unless |value - expected| <= tolerance (NaN fails). */
bool CheckNear(double value, double expected, double tolerance, const char* file, int line,
  const std::string& what);

/**
 * The larger one; NaN if either is NaN, where std::max may forget it, so that the worst of many is
 * no number when one of them is none.
 */
double Larger(double a, double b);

/**
 * The folder of this test's own files: RELIEVO_TEST_OUTPUT, else the current folder.
 * Made when it is not there.
 */
std::string OutputFolder();

/**
 * Path of a real mesh (`bunny.off`) in the folder RELIEVO_DATA.
 * Empty, with a counted failure that says what to run, when the file is not there.
 */
std::string DataFile(const std::string& name);
}

/** Fails unless the condition holds; the message is the condition itself. */
#define RELIEVO_CHECK(condition)                                                                   \
  relievoTest::Check(static_cast<bool>(condition), __FILE__, __LINE__, #condition)

/** Fails unless the condition holds, with a message of your own (a std::string). */
#define RELIEVO_CHECK_THAT(condition, message)                                                     \
  relievoTest::Check(static_cast<bool>(condition), __FILE__, __LINE__, message)

/** Prints the measured value beside its limit and fails when it is above (or NaN). */
#define RELIEVO_CHECK_AT_MOST(value, limit, what)                                                  \
  relievoTest::CheckAtMost(value, limit, __FILE__, __LINE__, what)

/** Fails unless value is within tolerance of expected. */
#define RELIEVO_CHECK_NEAR(value, expected, tolerance, what)                                       \
  relievoTest::CheckNear(value, expected, tolerance, __FILE__, __LINE__, what)

#endif
