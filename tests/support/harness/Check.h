// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Check.h
 * @brief Checks of a test: each failure is printed with its location and counted; the test goes on.
 *
 * A test program has one relievoTest::Session (Session.h), runs checks, and returns its Result().
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

/**
 * Number of checks that `work` fails, not counted as failures: for tests that prove a check can
 * fail.
 */
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
 * The larger value; NaN if either is NaN, which std::max may ignore, so that the worst of many
 * values is NaN if one of them is.
 */
double Larger(double a, double b);

/**
 * The folder for this test's files: RELIEVO_TEST_OUTPUT, otherwise the current folder. Made if
 * missing.
 */
std::string OutputFolder();

/**
 * Path of a real mesh (`bunny.off`) in the folder RELIEVO_DATA. Empty, with a counted failure that
 * names the remedy, if the file is missing.
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
