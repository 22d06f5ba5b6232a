// SPDX-License-Identifier: BSD-3-Clause
#include "StlSource.h"

#if CARTESIAN_STL_PARSER

#include "vtkMemoryResourceStream.h"
#include "vtkNew.h"

#include <array>
#include <string>
#include <utility>

namespace cartesian
{

vtkSmartPointer<vtkResourceParser> stlSource(std::FILE* file)
{
  std::string text;
  std::array<char, 1 << 16> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), file))
  {
    text.append(block.data(), size);
  }
  vtkNew<vtkMemoryResourceStream> stream;
  stream->SetBuffer(std::move(text));
  auto parser = vtkSmartPointer<vtkResourceParser>::New();
  parser->SetStream(stream);
  return parser;
}

}

#endif
