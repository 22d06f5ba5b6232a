// SPDX-License-Identifier: BSD-3-Clause
// Hands Open CASCADE's progress on.
#pragma once

#include "CadPart.h"

#include <Message_ProgressIndicator.hxx>

namespace cartesian
{

// From `begin` to `end` of the whole work.
class CadProgress : public Message_ProgressIndicator
{
  DEFINE_STANDARD_RTTI_INLINE(CadProgress, Message_ProgressIndicator)

public:
  CadProgress(const CadReport& report, double begin, double end)
    : report_(report)
    , begin_(begin)
    , end_(end)
  {
  }

private:
  void Show(const Message_ProgressScope& /*scope*/, Standard_Boolean /*force*/) override
  {
    report_.progress(begin_ + (end_ - begin_) * GetPosition());
  }

  const CadReport& report_;
  double begin_;
  double end_;
};

}
