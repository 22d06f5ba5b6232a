// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/Schemes.h"

#include "Base/Error.h"

namespace cartesian
{

namespace
{

std::string block(const std::string& name, const std::string& initial, const std::string& entries)
{
  return name +
    (entries.empty() ? " { default " + initial + "; }\n"
                     : "\n{\n    default         " + initial + ";\n" + entries + "}\n");
}

}

std::string schemesOf(const Schemes& schemes)
{
  const std::string corrected = "limited corrected " + number(schemes.correction);
  return "ddtSchemes { default steadyState; }\n" +
    block("gradSchemes", "Gauss linear", schemes.gradients) +
    block("divSchemes", "none", schemes.divergences) +
    block("laplacianSchemes", "Gauss linear " + corrected, {}) +
    block("interpolationSchemes", "linear", {}) + block("snGradSchemes", corrected, {}) +
    (schemes.divergences.empty() ? "" : "wallDist { method meshWave; }\n");
}

}
