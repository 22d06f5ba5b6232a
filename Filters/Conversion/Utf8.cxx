// SPDX-License-Identifier: BSD-3-Clause
#include "Utf8.h"

#include "vtkNew.h"
#include "vtkUTF8TextCodec.h"

#include <algorithm>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr unsigned char LastOfAscii = 0x7f;

bool isAsciiByte(unsigned char byte)
{
  return byte <= LastOfAscii;
}

}

bool isAscii(const std::string& text)
{
  return std::all_of(text.begin(), text.end(), isAsciiByte);
}

std::string toUtf8(const std::string& text)
{
  if (isAscii(text))
  {
    return text;
  }
  std::istringstream stream(
    text + "\n\n\n"); // VTK overlooks a character that is cut off at the end
  if (vtkNew<vtkUTF8TextCodec>()->IsValid(stream))
  {
    return text;
  }
  std::string converted;
  for (const unsigned char byte : text)
  {
    if (isAsciiByte(byte))
    {
      converted += static_cast<char>(byte);
    }
    else // two bytes: the upper two bits, the lower six
    {
      converted += static_cast<char>(0xc0U | byte >> 6U);
      converted += static_cast<char>(0x80U | (byte & 0x3fU));
    }
  }
  return converted;
}

}
