// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame report (vtkRelievoPass::GetFrameReport) for display in windows.
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
    QString Name;   ///< name in the report
    QString Label;  ///< display name
    QString Code;   ///< code of the reason: see vtkRelievoStage::GetReasonCode
    QString Reason; ///< the reason in words: clauses separated by "; ", the most important first
    bool Ran = false;
    double Milliseconds = -1.0; ///< on the GPU; -1: not measured (yet)
    double Bytes = 0.0;         ///< of GPU memory
    int DrawCalls = -1;         ///< -1: not counted

    /// No stage: VTK's own drawing.
    bool IsDelegate() const { return this->Name == "delegate"; }

    /// The reason's first clause; empty for a stage that takes no part in the picture.
    QString GetShortReason() const;
  };
  QVector<Stage> Stages;
  double Milliseconds = -1.0; ///< of the whole frame
  double Bytes = 0.0;

  /// Parses JSON; without stages if it contains no report.
  explicit FrameReport(const QByteArray& json = QByteArray());

  ///@{
  /// "<0.001", "0.041", "41.2"; "16.0 MiB"; an en dash for a missing number.
  static QString FormatMilliseconds(double milliseconds);
  static QString FormatBytes(double bytes);
  ///@}
};
}

#endif
