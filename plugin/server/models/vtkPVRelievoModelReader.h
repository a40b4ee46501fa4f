// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoModelReader
 * @brief vtkRelievoModelReader for ParaView's lists of names, where no name is a word of its own.
 *
 * ParaView sends that word as it stands in the list. It is NoName, which no file would use, rather
 * than "None", which a bone may well be called.
 */
#ifndef vtkPVRelievoModelReader_h
#define vtkPVRelievoModelReader_h

#include "vtkRelievoModelReader.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoModelReader : public vtkRelievoModelReader
{
public:
  static vtkPVRelievoModelReader* New();
  vtkTypeMacro(vtkPVRelievoModelReader, vtkRelievoModelReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The word "(none)", as models.xml has it. */
  static const char* const NoName;

  void SetBlendAnimation(const char* name) override;
  void SetWeightsOf(const char* name) override;

protected:
  vtkPVRelievoModelReader() = default;
  ~vtkPVRelievoModelReader() override = default;

private:
  vtkPVRelievoModelReader(const vtkPVRelievoModelReader&) = delete;
  void operator=(const vtkPVRelievoModelReader&) = delete;
};

#endif
