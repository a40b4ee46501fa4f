// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleThread.h"

#include "vtkGenericOpenGLRenderWindow.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QOpenGLContext>

namespace viewer
{
//------------------------------------------------------------------------------
SampleThread::SampleThread(QVTKOpenGLNativeWidget* view)
  : View(view)
{
}

//------------------------------------------------------------------------------
bool SampleThread::IsPossible()
{
  return QOpenGLContext::supportsThreadedOpenGL();
}

//------------------------------------------------------------------------------
void SampleThread::Lend()
{
  this->View->doneCurrent();
  this->View->context()->moveToThread(this);
  this->Lent = true;
  this->start();
}

//------------------------------------------------------------------------------
void SampleThread::TakeBack()
{
  if (this->Lent)
  {
    this->wait();
    this->Lent = false;
  }
}

//------------------------------------------------------------------------------
void SampleThread::run()
{
  this->View->makeCurrent();
  this->View->renderWindow()->Render();
  this->View->renderWindow()->WaitForCompletion();
  this->View->doneCurrent();
  this->View->context()->moveToThread(this->View->thread());
}
}
