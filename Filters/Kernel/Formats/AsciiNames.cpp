// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/AsciiNames.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <vector>

namespace cartesian
{

namespace
{

// Consecutive letters of an alphabet, in Latin ones, with - between them; _ is no letter, or one without a sound.
struct Alphabet
{
  std::uint32_t first; // code point
  const char* letters;
};

constexpr std::array<Alphabet, 4> Alphabets = { {
  { 0xc0, // Latin
    "A-A-A-A-Ae-Aa-Ae-C-E-E-E-E-I-I-I-I-D-N-O-O-O-O-Oe-x-Oe-U-U-U-Ue-Y-Th-ss-a-a-a-a-"
    "ae-aa-ae-c-e-e-e-e-i-i-i-i-d-n-o-o-o-o-oe-_-oe-u-u-u-ue-y-th-y-A-a-A-a-A-a-C-c-"
    "C-c-C-c-C-c-D-d-D-d-E-e-E-e-E-e-E-e-E-e-G-g-G-g-G-g-G-g-H-h-H-h-I-i-I-i-I-i-I-i-"
    "I-i-IJ-ij-J-j-K-k-k-L-l-L-l-L-l-L-l-L-l-N-n-N-n-N-n-n-N-n-O-o-O-o-O-o-Oe-oe-R-r-"
    "R-r-R-r-S-s-S-s-S-s-S-s-T-t-T-t-T-t-U-u-U-u-U-u-U-u-U-u-U-u-W-w-Y-y-Y-Z-z-Z-z-Z-"
    "z-s" },
  { 0x391, // Greek
    "A-B-G-D-E-Z-I-Th-I-K-L-M-N-X-O-P-R-_-S-T-Y-F-Ch-Ps-O" },
  { 0x3b1, "a-b-g-d-e-z-i-th-i-k-l-m-n-x-o-p-r-s-s-t-y-f-ch-ps-o" },
  { 0x410, // Cyrillic
    "A-B-V-G-D-E-Zh-Z-I-J-K-L-M-N-O-P-R-S-T-U-F-H-C-Ch-Sh-Shch-_-Y-_-E-Yu-Ya-a-b-v-g-"
    "d-e-zh-z-i-j-k-l-m-n-o-p-r-s-t-u-f-h-c-ch-sh-shch-_-y-_-e-yu-ya" },
} };

std::string inLatin(std::uint32_t code)
{
  for (const Alphabet& alphabet : Alphabets)
  {
    std::istringstream words(alphabet.letters);
    std::string letter;
    for (std::uint32_t at = alphabet.first; at <= code && std::getline(words, letter, '-'); ++at)
    {
      if (at == code)
      {
        return letter;
      }
    }
  }
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "u%04x", static_cast<unsigned>(code));
  return text.data();
}

// How many bytes of UTF-8 follow this first one.
int bytesAfter(unsigned char first)
{
  return first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
}

}

std::string asciiName(const std::string& name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const auto byte = static_cast<unsigned char>(name[i]);
    if (byte < 0x80)
    {
      result += name[i];
      continue;
    }
    const int more = bytesAfter(byte);
    std::uint32_t code = more == 0 ? byte : byte & (0x3fU >> more);
    for (int n = 0; n < more && i + 1 < name.size(); ++n)
    {
      code = (code << 6) | (static_cast<unsigned char>(name[++i]) & 0x3fU);
    }
    result += inLatin(code);
  }
  return result;
}

}
