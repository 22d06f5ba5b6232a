// SPDX-License-Identifier: BSD-3-Clause
#include "CadEncoding.h"

#include "CadPart.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>

namespace cartesian
{

namespace
{

struct Encoding
{
  const char* name;
  const char* ofSystem; // iconv's
};

// By CadEncoding.
constexpr std::array<Encoding, 11> Encodings{ { { "Automatic", "" }, { "UTF-8", "UTF-8" },
  { "Western European", "CP1252" }, { "Central European", "CP1250" }, { "Cyrillic", "CP1251" },
  { "Greek", "CP1253" }, { "Turkish", "CP1254" }, { "Simplified Chinese", "GB18030" },
  { "Traditional Chinese", "BIG5" }, { "Japanese", "CP932" }, { "Korean", "CP949" } } };

const Encoding& of(CadEncoding encoding)
{
  return Encodings.at(static_cast<std::size_t>(encoding));
}

unsigned char byteAt(const std::string& text, std::size_t i)
{
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

bool isIn(unsigned char byte, unsigned char first, unsigned char last)
{
  return byte >= first && byte <= last;
}

bool isHigh(unsigned char byte)
{
  return byte >= 0x80;
}

// Characters of two bytes: which may be the first and the second, and which characters are frequent.
struct Pairs
{
  CadEncoding encoding;
  bool (*mayBegin)(unsigned char first);
  bool (*mayEnd)(unsigned char second);
  bool (*isFrequent)(unsigned char first, unsigned char second);
  bool mayBeAlone; // else a single one is more likely an accent or a quotation mark
};

// GB 18030 has longer characters, which are two such pairs, each with a digit.
constexpr std::array<Pairs, 3> OfTwoBytes{ {
  { CadEncoding::SimplifiedChinese, [](unsigned char c) { return isIn(c, 0x81, 0xFE); },
    [](unsigned char c) { return isIn(c, 0x30, 0x39) || (isIn(c, 0x40, 0xFE) && c != 0x7F); },
    [](unsigned char a, unsigned char b) { return isIn(a, 0xB0, 0xD7) && isIn(b, 0xA1, 0xFE); },
    true },
  { CadEncoding::Japanese,
    [](unsigned char c) { return isIn(c, 0x81, 0x9F) || isIn(c, 0xE0, 0xFC); },
    [](unsigned char c) { return isIn(c, 0x40, 0xFC) && c != 0x7F; },
    [](unsigned char a, unsigned char /*b*/) { return isIn(a, 0x82, 0x83) || isIn(a, 0x88, 0x97); },
    false },
  { CadEncoding::TraditionalChinese, [](unsigned char c) { return isIn(c, 0xA1, 0xF9); },
    [](unsigned char c) { return isIn(c, 0x40, 0x7E) || isIn(c, 0xA1, 0xFE); },
    [](unsigned char a, unsigned char /*b*/) { return isIn(a, 0xA4, 0xC6); }, false },
} };

// Whether all high bytes are such characters, most of them frequent ones.
bool fits(const std::string& text, const Pairs& pairs)
{
  std::size_t all = 0;
  std::size_t frequent = 0;
  std::size_t inWords = 0; // beside another
  std::size_t end = 0;     // of the character before
  bool isWord = false;
  for (std::size_t i = 0; i < text.size();)
  {
    const unsigned char first = byteAt(text, i);
    const unsigned char second = byteAt(text, i + 1);
    if (!isHigh(first))
    {
      ++i;
      continue;
    }
    if (!pairs.mayBegin(first) || !pairs.mayEnd(second))
    {
      return false;
    }
    const bool isBeside = all > 0 && end == i;
    inWords += isBeside ? (isWord ? 1 : 2) : 0;
    isWord = isBeside;
    ++all;
    frequent += pairs.isFrequent(first, second);
    end = i += 2;
  }
  return 2 * frequent > all && (pairs.mayBeAlone || 2 * inWords > all);
}

// Whether words consist of letters beyond ASCII.
bool isOtherAlphabet(const std::string& text)
{
  constexpr std::size_t ShortestWord = 3; // letters, on average
  std::size_t high = 0;
  std::size_t words = 0;
  std::size_t letters = 0; // in Windows' code pages
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const unsigned char c = byteAt(text, i);
    high += isHigh(c);
    letters += c >= 0xC0;
    words += isHigh(c) && (i == 0 || !isHigh(byteAt(text, i - 1)));
  }
  return high >= ShortestWord * words && 10 * letters > 9 * high;
}

}

bool isUtf8(const std::string& text)
{
  for (std::size_t i = 0; i < text.size();)
  {
    const unsigned char first = byteAt(text, i++);
    const int more = first < 0x80 ? 0
      : isIn(first, 0xC2, 0xDF)   ? 1
      : isIn(first, 0xE0, 0xEF)   ? 2
      : isIn(first, 0xF0, 0xF4)   ? 3
                                  : -1;
    if (more < 0)
    {
      return false;
    }
    for (int k = 0; k < more; ++k)
    {
      if (!isIn(byteAt(text, i++), 0x80, 0xBF))
      {
        return false;
      }
    }
  }
  return true;
}

CadEncoding guessedEncoding(const std::string& text)
{
  const auto* const pairs = std::find_if(OfTwoBytes.begin(), OfTwoBytes.end(),
    [&](const Pairs& candidate) { return fits(text, candidate); });
  return pairs != OfTwoBytes.end() ? pairs->encoding
    : isOtherAlphabet(text)        ? CadEncoding::Cyrillic
                                   : CadEncoding::WesternEuropean;
}

std::string nameOf(CadEncoding encoding)
{
  return of(encoding).name;
}

std::string toUtf8(const std::string& text, CadEncoding from)
{
  constexpr std::size_t Room = 4096;
  const iconv_t converter = iconv_open("UTF-8", of(from).ofSystem);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): POSIX defines it so
  if (converter == reinterpret_cast<iconv_t>(-1))
  {
    throw CadError("has names in an encoding that this system does not know (" +
      std::string(of(from).ofSystem) + "). Choose another Name Encoding.");
  }
  std::string copy = text; // iconv takes no constant
  std::string result;
  std::array<char, Room> part;
  char* at = copy.data();
  std::size_t left = copy.size();
  while (left > 0)
  {
    char* to = part.data();
    std::size_t room = part.size();
    const bool isDone = iconv(converter, &at, &left, &to, &room) != static_cast<std::size_t>(-1);
    const int why = errno;
    result.append(part.data(), part.size() - room);
    if (!isDone && why != E2BIG)
    {
      result += "\xEF\xBF\xBD";
      ++at;
      --left;
    }
  }
  iconv_close(converter);
  return result;
}

}
