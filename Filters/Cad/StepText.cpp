// SPDX-License-Identifier: BSD-3-Clause
#include "StepText.h"

#include "CadPart.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace cartesian
{

namespace
{

bool isSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool isWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Reads values from text.
class Parser
{
public:
  explicit Parser(std::string_view text)
    : text_(text)
  {
  }

  std::vector<StepEntity> entities()
  {
    std::vector<StepEntity> found;
    const bool isComplex = take('(');
    do
    {
      StepEntity entity;
      entity.type = word();
      entity.values = list();
      found.push_back(std::move(entity));
    } while (isComplex && !take(')'));
    return found;
  }

private:
  [[noreturn]] static void fail()
  {
    throw CadError("is damaged: an entity of its triangles cannot be understood. Export it again.");
  }

  char next()
  {
    while (at_ < text_.size() && isSpace(text_[at_]))
    {
      ++at_;
    }
    if (at_ == text_.size())
    {
      fail();
    }
    return text_[at_];
  }

  bool take(char c)
  {
    const bool isThere = next() == c;
    at_ += isThere;
    return isThere;
  }

  std::string word()
  {
    next();
    const std::size_t begin = at_;
    while (at_ < text_.size() && isWord(text_[at_]))
    {
      ++at_;
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::vector<StepValue> list()
  {
    std::vector<StepValue> values;
    if (!take('('))
    {
      fail();
    }
    while (!take(')'))
    {
      values.push_back(value());
      take(',');
    }
    return values;
  }

  StepValue value()
  {
    StepValue found;
    const char c = next();
    if (c == '(')
    {
      found.list = list();
    }
    else if (c == '\'')
    {
      found.text = quoted();
    }
    else if (c == '#')
    {
      ++at_;
      found.reference = std::atoi(word().c_str());
    }
    else if (c == '.' || c == '$' || c == '*')
    {
      found.text = text_.substr(at_, 1);
      ++at_;
      if (c == '.')
      {
        found.text = word();
        take('.');
      }
    }
    else if (std::isalpha(static_cast<unsigned char>(c)) != 0)
    {
      found.text = word();
      found.list = list();
    }
    else
    {
      found.number = number();
    }
    return found;
  }

  double number()
  {
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::string_view("+-.0123456789eE").find(text_[at_]) < 15)
    {
      ++at_;
    }
    if (at_ == begin)
    {
      fail();
    }
    return std::atof(std::string(text_.substr(begin, at_ - begin)).c_str());
  }

  // Two apostrophes are one.
  std::string quoted()
  {
    const std::size_t begin = ++at_;
    for (; at_ < text_.size(); ++at_)
    {
      if (text_[at_] == '\'' && (at_ + 1 == text_.size() || text_[++at_] != '\''))
      {
        return decodedText(text_.substr(begin, at_ - begin - 1));
      }
    }
    fail();
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void addUtf8(std::string& text, unsigned long code)
{
  const auto put = [&](unsigned long byte) { text += static_cast<char>(byte); };
  if (code < 0x80)
  {
    put(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  put(((0xFF00U >> (more + 1)) & 0xFFU) | (code >> (6 * more)));
  for (int i = more - 1; i >= 0; --i)
  {
    put(0x80U | ((code >> (6 * i)) & 0x3FU));
  }
}

// The end of the entity that begins there.
std::size_t endOf(const std::string& text, std::size_t begin)
{
  bool isQuoted = false;
  for (std::size_t i = begin; i < text.size(); ++i)
  {
    isQuoted ^= text[i] == '\'';
    if (text[i] == ';' && !isQuoted)
    {
      return i;
    }
  }
  return text.size();
}

}

std::string decodedText(std::string_view text)
{
  std::string result;
  std::size_t digits = 0; // of a character, between \X2\ or \X4\ and \X0\.
  for (std::size_t i = 0; i < text.size();)
  {
    const std::string_view code = text.substr(i, 4);
    const auto hexadecimal = [&](std::size_t from, std::size_t count) {
      return std::strtoul(std::string(text.substr(from, count)).c_str(), nullptr, 16);
    };
    if (code == "\\X2\\" || code == "\\X4\\" || code == "\\X0\\")
    {
      digits = code[2] == '2' ? 4 : code[2] == '4' ? 8 : 0;
      i += 4;
    }
    else if (digits > 0)
    {
      addUtf8(result, hexadecimal(i, digits));
      i += digits;
    }
    else if (code.substr(0, 3) == "\\X\\" && i + 5 <= text.size())
    {
      addUtf8(result, hexadecimal(i + 3, 2));
      i += 5;
    }
    else
    {
      result += text[i];
      i += text.substr(i, 2) == "''" || text.substr(i, 2) == "\\\\" ? 2 : 1;
    }
  }
  return result;
}

StepText::StepText(const std::string& text)
{
  std::size_t at = text.find("DATA;");
  while (at < text.size())
  {
    const std::size_t end = endOf(text, at);
    std::string_view entity = std::string_view(text).substr(at, end - at);
    entity.remove_prefix(std::min(entity.find('#'), entity.size()));
    const std::size_t equals = entity.find('=');
    if (equals != std::string_view::npos)
    {
      entities_[std::atoi(std::string(entity.substr(1, equals - 1)).c_str())] =
        entity.substr(equals + 1);
    }
    at = end + 1;
  }
}

std::vector<int> StepText::all(const std::string& type) const
{
  std::vector<int> numbers;
  for (const auto& [number, entity] : entities_)
  {
    const std::size_t at = entity.find(type);
    const std::size_t end = at + type.size();
    // Of a complex one, among its first words.
    if (at != std::string_view::npos && (at == 0 || !isWord(entity[at - 1])) &&
      end < entity.size() && !isWord(entity[end]) &&
      entity.substr(0, at).find('\'') == std::string_view::npos)
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

std::vector<StepEntity> StepText::at(int number) const
{
  const auto found = entities_.find(number);
  return found == entities_.end() ? std::vector<StepEntity>() : Parser(found->second).entities();
}

StepEntity StepText::part(int number, const std::string& type) const
{
  for (StepEntity& entity : at(number))
  {
    if (entity.type == type)
    {
      return std::move(entity);
    }
  }
  return {};
}

}
