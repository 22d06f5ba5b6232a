#pragma once

#include "Document.h"

#include <gp_Pnt.hxx>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cartesian
{

// In closed form, in millimetres whatever the unit of the file.
struct SolidFacts
{
  std::string name;
  double volume = 0;
  double area = 0;
  std::optional<gp_Pnt> centre = {}; // of gravity
};

enum class Integrals
{
  FixedOrder, // of OCCT: to 1e-9 on planes and quadrics, wrong by up to 3e-3 on B-splines
  Adaptive,   // volumes to 1e-7 on all surfaces; slow
  AcrossKinks // volumes to 1e-5 where a face with kinks has holes
};

struct Facts
{
  std::vector<SolidFacts> solids = {};
  std::optional<double> area = {}; // of all faces; else the sum over the solids
  int faces = 0;
  int openEdges = 0;                             // of the shape, edges that one face has
  std::map<std::string, double> boundaries = {}; // areas of faces of a name, colour or layer
  std::map<std::string, double> others = {};     // whatever else a test asserts
  Integrals integrals = Integrals::FixedOrder;   // that check these facts
};

// Throws std::runtime_error where the shape is not what the facts say, by OCCT's integrals.
void check(const Facts& facts, const TopoDS_Shape& shape,
  const std::vector<std::pair<TopoDS_Shape, std::string>>& boundaries = {});

// One line.
std::string json(const Facts& facts);

}
