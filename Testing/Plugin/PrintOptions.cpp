// Prints the kernel's table of options as JSON, for TestOptions.py.
#include "Mesher/OptionTable.h"

#include <cmath>
#include <cstdio>

int main()
{
  const char* separator = "[";
  for (const cartesian::NamedOption& option : cartesian::optionTable())
  {
    std::printf("%s\n{ \"name\": \"%s\", \"initial\": %.17g, \"least\": %.17g, ", separator,
      option.name, option.initial, option.range.least);
    if (std::isfinite(option.range.most))
    {
      std::printf("\"most\": %.17g, ", option.range.most);
    }
    std::printf("\"with_most\": %s, \"unit\": \"%s\", \"choices\": [",
      option.range.withMost ? "true" : "false", option.unit);
    const char* comma = "";
    for (const char* choice : option.choices)
    {
      std::printf("%s\"%s\"", comma, choice);
      comma = ", ";
    }
    std::printf("] }");
    separator = ",";
  }
  std::printf("\n]\n");
}
