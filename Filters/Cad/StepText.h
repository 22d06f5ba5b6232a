// SPDX-License-Identifier: BSD-3-Clause
// The entities of a STEP file as they are written, for those that Open CASCADE does not know.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cartesian
{

// A parameter: a number, a reference (#12), a text, a list, or a word such as $ or .MILLI.
struct StepValue
{
  double number = 0;
  int reference = 0;
  std::string text; // also the word, and a typed value's type: LENGTH_MEASURE(25.4) is a list
  std::vector<StepValue> list;
};

struct StepEntity
{
  std::string type;
  std::vector<StepValue> values;
};

class StepText
{
public:
  // Keeps references to it.
  explicit StepText(const std::string& text);

  // By their numbers, of a type.
  std::vector<int> all(const std::string& type) const;

  // The parts of an entity, which is several if it is complex. Empty if there is none; throws CadError if it is damaged.
  std::vector<StepEntity> at(int number) const;

  // The one part of that type; of another, or of none, one without values.
  StepEntity part(int number, const std::string& type) const;

private:
  std::map<int, std::string_view> entities_;
};

// In UTF-8, what the standard encodes as \X2\00E4\X0\ and such.
std::string decodedText(std::string_view text);

}
