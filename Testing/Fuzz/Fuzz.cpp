// libFuzzer's target: any bytes give a valid mesh or a refusal (Support/FuzzedSurface.h).
#include "Support/FuzzedSurface.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  const ::testing::AssertionResult result = cartesian::meshesFromBytes(bytes, size);
  if (!result)
  {
    std::fprintf(stderr, "%s\n", result.message());
    std::abort();
  }
  return 0;
}
