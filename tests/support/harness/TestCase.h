// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCase.h
 * @brief A test among those of its folder's program: `relievo_tests_FOLDER --case NAME [word...]`.
 *
 *     namespace testSomething
 *     {
 *     RELIEVO_TEST_CASE(testSomething)
 *     {
 *       relievoTest::Session session;
 *       RELIEVO_CHECK(1 + 1 == 2);
 *       return session.Result();
 *     }
 *     }
 *
 * Each source has a namespace of its name, since several are compiled at once. ctest runs each case
 * in a process of its own; `--all` runs all of them, those declared RELIEVO_TEST_CASE_APART in
 * processes of their own.
 */
#ifndef relievoTestCase_h
#define relievoTestCase_h

namespace relievoTest
{
/** A case of this program; made before main() by the macros below. */
class TestCase
{
public:
  /** Returns the exit status; arguments are those of main(), with the case's name first. */
  using Function = int (*)(int argc, char* argv[]);

  TestCase(const char* name, Function function, bool apart);
};

/**
 * Whether the case's first argument is `long`, as in tests labelled `nightly`, which cover all
 * cases.
 */
bool IsLong(int argc, char* argv[]);
}

#define RELIEVO_DECLARED_TEST_CASE(name, apart)                                                    \
  static int name(int argc, char* argv[]);                                                         \
  static const relievoTest::TestCase name##Case(#name, name, apart);                               \
  int name([[maybe_unused]] int argc, [[maybe_unused]] char* argv[])

/** Begins a case; `argc` and `argv` are its arguments. */
#define RELIEVO_TEST_CASE(name) RELIEVO_DECLARED_TEST_CASE(name, false)

/**
 * Begins a case that permanently changes its process: limits, signals, the environment, threads.
 */
#define RELIEVO_TEST_CASE_APART(name) RELIEVO_DECLARED_TEST_CASE(name, true)

#endif
