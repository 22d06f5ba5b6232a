// SPDX-License-Identifier: BSD-3-Clause
#include "UpstreamSettings.h"

#include "Base/Error.h"
#include "Base/Words.h"
#include "Mesher/OptionTable.h"
#include "vtkCartesianMesher.h"
#include "vtkRefinementRegion.h"

#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

namespace cartesian
{

namespace
{

using Lines = std::vector<std::pair<std::string, std::string>>; // name, value

// What PrintSelf says of an algorithm: all properties by name, as tests check.
Lines printed(vtkAlgorithm* algorithm)
{
  std::ostringstream stream;
  algorithm->PrintSelf(stream, vtkIndent());
  std::istringstream text(stream.str());
  Lines lines;
  for (std::string line; std::getline(text, line);)
  {
    const std::size_t colon = line.find(':');
    if (line.empty() || line[0] == ' ') // of a table
    {
      const std::size_t row = line.find_first_not_of(' ');
      if (!lines.empty() && row != std::string::npos)
      {
        std::string& value = lines.back().second;
        value += (value.empty() ? "" : "; ") + line.substr(row);
      }
    }
    else if (colon != std::string::npos)
    {
      const std::size_t value = line.find_first_not_of(' ', colon + 1);
      lines.emplace_back(
        line.substr(0, colon), value == std::string::npos ? "" : line.substr(value));
    }
  }
  return lines;
}

std::string valueInWords(const std::string& label, const std::string& value)
{
  static const std::vector<NamedOption> table = optionTable();
  const auto option = std::find_if(
    table.begin(), table.end(), [&](const NamedOption& known) { return known.name == label; });
  const auto choice = static_cast<std::size_t>(std::max(0, std::atoi(value.c_str())));
  return option != table.end() && choice < option->choices.size() ? option->choices[choice] : value;
}

std::string nameInPanel(vtkAlgorithm* algorithm)
{
  return wordsOf(std::string(algorithm->GetClassName()).substr(3)); // vtk
}

class Search
{
public:
  Upstream run(vtkAlgorithm* algorithm)
  {
    visitInputs(algorithm);
    return std::move(found_);
  }

private:
  void visitInputs(vtkAlgorithm* algorithm)
  {
    for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
    {
      for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
      {
        vtkAlgorithm* input = algorithm->GetInputAlgorithm(port, i);
        if (input && seen_.insert(input).second)
        {
          visitInputs(input);
          visit(input);
        }
      }
    }
  }

  void visit(vtkAlgorithm* algorithm)
  {
    auto* ours = vtkCartesianAlgorithm::SafeDownCast(algorithm);
    if (ours)
    {
      found_.warnings.insert(
        found_.warnings.end(), ours->GetWarnings().begin(), ours->GetWarnings().end());
      found_.hasMesher = found_.hasMesher || vtkCartesianMesher::SafeDownCast(ours);
    }
    if (ours || vtkRefinementRegion::SafeDownCast(algorithm))
    {
      addChanged(algorithm);
    }
    else if (algorithm->GetNumberOfInputPorts() == 0)
    {
      addFile(algorithm);
    }
  }

  void addChanged(vtkAlgorithm* algorithm)
  {
    const auto fresh =
      vtkSmartPointer<vtkAlgorithm>::Take(vtkAlgorithm::SafeDownCast(algorithm->NewInstance()));
    std::map<std::string, std::string> defaults;
    for (const auto& [name, value] : printed(fresh))
    {
      defaults[name] = value;
    }
    for (const auto& [name, value] : printed(vtkSmartPointer<vtkTrivialProducer>::New()))
    {
      defaults.erase(name); // what all algorithms have
    }
    defaults.erase("NumberOfThreads"); // the mesh does not depend on it
    if (defaults.count("BoundaryArray") == 1)
    {
      defaults["BoundaryArray"] = "Automatic"; // so the panel writes none
    }
    for (const auto& [name, value] : printed(algorithm))
    {
      const auto known = defaults.find(name);
      if (known != defaults.end() && known->second != value && !value.empty())
      {
        const std::string label = wordsOf(name);
        found_.settings.push_back({ nameInPanel(algorithm), label, valueInWords(label, value) });
      }
    }
  }

  // Without its folder, which another computer has not.
  void addFile(vtkAlgorithm* reader)
  {
    for (const auto& [name, value] : printed(reader))
    {
      if ((name == "FileName" || name == "File Name") && !value.empty() && value[0] != '(')
      {
        found_.settings.push_back(
          { nameInPanel(reader), "File", value.substr(value.find_last_of("/\\") + 1) });
      }
    }
  }

  Upstream found_;
  std::set<vtkAlgorithm*> seen_;
};

}

Upstream upstreamOf(vtkAlgorithm* algorithm)
{
  return Search().run(algorithm);
}

}
