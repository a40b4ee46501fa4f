// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReaderErrors.h
 * @brief How many errors an algorithm reports.
 */
#ifndef ReaderErrors_h
#define ReaderErrors_h

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace relievoTest
{
/** Updates it, without a word on the terminal; the number of errors that it reported. */
inline int CountErrors(vtkAlgorithm* algorithm)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ErrorEvent, count);
  algorithm->Update();
  algorithm->RemoveObserver(tag);
  return errors;
}
}

#endif
