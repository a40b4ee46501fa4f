// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Session.h
 * @brief Watches one test program: any VTK error or warning, or a VTK object left alive, fails it.
 *
 *     int main()
 *     {
 *       relievoTest::Session session;
 *       RELIEVO_CHECK(1 + 1 == 2);
 *       return session.Result();
 *     }
 */
#ifndef relievoTestSession_h
#define relievoTestSession_h

#include <memory>
#include <string>
#include <vector>

namespace relievoTest
{
/**
 * Makes VTK's errors and warnings failures, from construction until Result().
 * One at a time in a process.
 */
class Session
{
public:
  Session();
  ~Session();

  /**
   * Ignores messages that contain `text`: for VTK's own warnings that are unrelated to the test.
   */
  void Allow(const std::string& text);

  /**
   * Exit status of the test: 0, or 1 after any failed check. Call it last, after the test's own
   * objects are destroyed: every VTK object made since construction and still alive is a failure
   * (see LeakCounter.h; process-wide singletons of VTK are not counted).
   */
  int Result();

  Session(const Session&) = delete;
  void operator=(const Session&) = delete;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

/**
 * Expects VTK errors or warnings while it lives: they do not fail the test.
 *
 *     ExpectMessage expect("missing.exr");
 *     reader->Update();                      // must say so
 *     RELIEVO_CHECK(expect.Count() == 1);
 *
 * Only messages that contain `text` are taken; the destructor fails when there was none.
 */
class ExpectMessage
{
public:
  explicit ExpectMessage(const std::string& text);
  ~ExpectMessage();

  /** Number of messages taken so far. */
  int Count() const;

  /** The messages taken so far. */
  const std::vector<std::string>& Messages() const;

  ExpectMessage(const ExpectMessage&) = delete;
  void operator=(const ExpectMessage&) = delete;

private:
  std::string Text;
  std::vector<std::string> Taken;
  friend bool TakeExpectedMessage(const std::string& message);
};
}

#endif
