// SPDX-License-Identifier: BSD-3-Clause
// The products of a STEP file as it is written: their names, representations, and places in assemblies.
#pragma once

#include "StepText.h"

#include <gp_Trsf.hxx>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace cartesian
{

// Of an instance of a product.
struct StepPlace
{
  gp_Trsf where;    // millimetres
  std::string name; // what the assembly calls it
};

// The parameter of an entity, from 0; an empty one if there is none.
const StepValue& valueOf(const StepEntity& entity, std::size_t i);

class StepProducts
{
public:
  // Borrows the text.
  explicit StepProducts(const StepText& step);

  // Products are known by their definitions' numbers; 0 if the representation belongs to none.
  int productOf(int representation) const;
  std::string nameOf(int product) const;
  // Also those that are related to its own.
  std::set<int> representationsOf(int product) const;
  // One without a move if no assembly places it.
  std::vector<StepPlace> placesOf(int product) const;

  // Millimetres in the unit of a representation's context.
  double millimetresIn(int context) const;

private:
  struct Usage
  {
    int assembly;
    std::string name;
    gp_Trsf where;
  };

  void readRepresentations();
  void readUsages();
  gp_Trsf whereOf(const StepEntity& relation, const StepEntity& frames, int part) const;
  gp_Trsf frameOf(int axes, int representation) const;
  double lengthOf(int unit) const;
  void addPlaces(int product, const StepPlace& inner, std::set<int>& above,
    std::vector<StepPlace>& places) const;

  const StepText& step_;
  std::map<int, std::set<int>> related_;     // representations of one shape, both ways
  std::map<int, int> products_;              // of representations
  std::map<int, std::vector<Usage>> usages_; // of products
};

}
