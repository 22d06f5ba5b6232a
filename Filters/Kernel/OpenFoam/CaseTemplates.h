// SPDX-License-Identifier: BSD-3-Clause
// The texts of a case, with placeholders such as @speed@: Templates/README.md describes them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cartesian
{

// Name and text of each file in Templates, which the build puts into the library.
using TemplateTexts = std::vector<std::pair<const char*, const char*>>;
const TemplateTexts& builtInTemplates();

class CaseTemplates
{
public:
  using Values = std::map<std::string, std::string>;

  // Those of the library; files in `folder`, if it is given, replace those of the same names. Throws Error
  // (BadParameter): it cannot be read, or has a file or a placeholder that does not exist here.
  explicit CaseTemplates(const std::filesystem::path& folder = {});

  // `values`: of all placeholders that the library's own template has.
  std::string filled(const std::string& name, const Values& values = {}) const;

private:
  std::map<std::string, std::string> texts_;
};

}
