// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoModelReader
 * @brief vtkRelievoModelReader for ParaView's lists of names, in which a word stands for no name.
 *
 * ParaView sends that word like any other entry. It is NoName, which no file would use, rather than
 * "None", which might be a bone's name.
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

  /** The word "(none)", also in models.xml. */
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
