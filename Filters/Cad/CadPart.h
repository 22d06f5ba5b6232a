// SPDX-License-Identifier: BSD-3-Clause
// What a file holds: solids, or sheets that enclose nothing, with what the file says about their faces.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace cartesian
{

// Why a file cannot be read, in words for the user that follow its name.
struct CadError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Empty where the file says nothing.
struct FaceAttributes
{
  std::string name;
  std::string color; // RRGGBB
  std::string layer;

  bool operator==(const FaceAttributes& other) const
  {
    return name == other.name && color == other.color && layer == other.layer;
  }
};

struct CadPart
{
  TopoDS_Shape shape; // placed, in millimetres
  std::string name;
  std::vector<FaceAttributes> faces; // in order of facesOf(shape)
  std::string instance;              // what the assembly calls this one of several
};

// Each once; from 1.
TopTools_IndexedMapOfShape facesOf(const TopoDS_Shape& shape);

// Edges that bound one face only, each once.
TopTools_IndexedMapOfShape freeEdges(const TopoDS_Shape& shape);

// Whether its faces are triangles, without surfaces and edges.
bool isTessellated(const TopoDS_Shape& shape);

// "(x, y, z)" of a shape's middle, in the unit of the result.
std::string placeOf(const TopoDS_Shape& shape, double unit);

// The attributes of faces that an operation has changed: `from` gives the faces that a face has become.
class FaceHistory
{
public:
  void add(const CadPart& part);
  void follow(const TopoDS_Shape& face, const TopoDS_Shape& image);
  std::vector<FaceAttributes> of(const TopoDS_Shape& shape) const;

private:
  TopTools_IndexedMapOfShape faces_;
  std::vector<FaceAttributes> attributes_;
};

// Tells the user something, or how far the work is.
struct CadReport
{
  std::function<void(double done)> progress;
  std::function<void(const std::string&)> note;
  std::function<void(const std::string&)> warning;
  // What is wrong in the file: told if Open CASCADE crashes, as most of it does no harm.
  std::function<void(const std::string&)> damage;
};

}
