// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame report (vtkRelievoPass::GetFrameReport) as windows show it.
 */
#ifndef FrameReport_h
#define FrameReport_h

#include <QByteArray>
#include <QString>
#include <QVector>

namespace relievoQt
{
struct FrameReport
{
  struct Stage
  {
    QString Name;   ///< of the report
    QString Label;  ///< for people
    QString Code;   ///< why it ran, or did not: see vtkRelievoStage::GetReasonCode
    QString Reason; ///< that in words: clauses with "; " between them, the first says most
    bool Ran = false;
    double Milliseconds = -1.0; ///< on the GPU; -1: not measured (yet)
    double Bytes = 0.0;         ///< of GPU memory
    int DrawCalls = -1;         ///< -1: not counted

    /// No stage: what the frame is drawn around.
    bool IsDelegate() const { return this->Name == "delegate"; }

    /// The reason's first clause; empty for a stage that has no part in the picture.
    QString GetShortReason() const;
  };
  QVector<Stage> Stages;
  double Milliseconds = -1.0; ///< of the whole frame
  double Bytes = 0.0;

  /// Of JSON; without stages if there is no report in it.
  explicit FrameReport(const QByteArray& json = QByteArray());

  ///@{
  /// "<0.001", "0.041", "41.2"; "16.0 MiB"; an en dash where there is no number.
  static QString FormatMilliseconds(double milliseconds);
  static QString FormatBytes(double bytes);
  ///@}
};
}

#endif
