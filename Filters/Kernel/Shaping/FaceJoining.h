// SPDX-License-Identifier: BSD-3-Clause
// Neighbouring faces of a cell that can be joined: between the same two cells, or in one boundary, with similar
// normals; none with a fixed cell beyond.
#pragma once

#include "Shaping/CellView.h"

#include <array>

namespace cartesian
{

bool hasEdgeFrom(const Ring& ring, std::uint32_t from, std::uint32_t to);

// Two polygons that share a chain of edges as one; false where they share several or meet elsewhere too.
bool joinRings(const Ring& first, const Ring& second, std::vector<std::uint32_t>& joined);

// Faces of a view that are joined or re-divided. All others stay.
struct JoinedFaces
{
  struct Group
  {
    std::vector<std::uint32_t> members; // faces of the view; no other group has them
    std::vector<std::uint32_t> ring;    // nodes of the view, counter-clockwise from outside
    FaceShape shape{};                  // of the ring
    bool recut = false;                 // with another group: together they cover what they did
  };
  std::vector<Group> groups;
};

// Cells of more faces keep them all: the time to join grows with the square of their number.
constexpr std::size_t MostFacesJoined = 100;

// Cosines of the angle between the normals of what is joined.
struct JoinSpec
{
  double boundary = 1; // 1: on one plane only
  double inner = 1;

  bool operator==(const JoinSpec& other) const
  {
    return boundary == other.boundary && inner == other.inner;
  }
};

// A view's shape with joined faces: those that stay, in their order, then the groups.
struct JoinedShape
{
  Polyhedron polyhedron;
  CellShape measures;
  std::vector<NeighbourCell> beyond;

  // The place of the first group.
  std::size_t kept(const JoinedFaces& joined) const
  {
    return polyhedron.faces() - joined.groups.size();
  }
};

// Joins faces of one view after the other; keeps its memory.
class FaceJoiner
{
public:
  explicit FaceJoiner(double featureCosine = 1)
    : featureCosine_(featureCosine)
  {
  }

  // Across edges of the wall that turn by more than this nothing is joined in any case.
  void joinAcross(double featureCosine) { featureCosine_ = featureCosine; }

  // What the others are about; `shape`: the view's. Both must stay as they are.
  void look(const CellView& view, const CellShape& shape);

  // All that fit together.
  JoinedFaces join(const JoinSpec& spec);

  // All ways to make one more face, counted as in JoinedShape, and one neighbour one, where their normals
  // make no smaller cosine; where they cannot be one, they are cut apart along another diagonal.
  std::vector<JoinedFaces> joinOneMore(
    const JoinedFaces& given, std::size_t face, double leastCosine);

  // Valid until the next call, or the next view.
  const JoinedShape& shapeOf(const JoinedFaces& joined);

private:
  // A face of the view that stays, or (number of faces) + group.
  using Part = std::uint32_t;

  struct Plane
  {
    Vector normal;
    double area;
  };

  std::uint32_t faces() const { return static_cast<std::uint32_t>(view_->faces.size()); }
  bool isFace(Part part) const { return part < faces(); }
  JoinedFaces::Group& groupOf(Part part) { return joined_.groups[part - faces()]; }
  const JoinedFaces::Group& groupOf(Part part) const { return joined_.groups[part - faces()]; }
  std::uint32_t firstMember(Part part) const
  {
    return isFace(part) ? part : groupOf(part).members.front();
  }
  Ring ringOf(Part part) const;
  Ring ringOf(const std::vector<std::uint32_t>& corners) const;
  template <class Is>
  bool anyPart(Is&& is) const;

  void begin(const JoinSpec& spec, const JoinedFaces& given);
  void listPairs();
  JoinedFaces joinedParts();
  Part partAt(std::size_t face) const;
  std::vector<Part> partsBeside(Part part) const;

  bool mayAnyFit() const;
  bool mayFit(std::uint32_t f, std::uint32_t g) const;
  bool isNearPlane(std::uint32_t f, const Vector& normal) const;
  bool isInner(std::uint32_t f) const;
  bool isNegligible(std::uint32_t f) const;
  bool isNegligiblePart(Part part) const;
  double leastCosine(std::uint32_t f) const;

  bool join(Part g, Part h);
  bool fitsTogether(Part g, Part h, double leastCosine) const;
  bool fitsWithNegligible() const;
  Part makeGroup(Part part);
  bool isBorderBetween(Part g, Part h) const;
  bool recut(Part g, Part h);
  double smallerOf(const std::array<std::vector<std::uint32_t>, 2>& parts, double leastCosine,
    double largest) const;
  bool hasEdge(std::uint32_t from, std::uint32_t to) const;
  bool hasTwin(const std::vector<std::uint32_t>& ring) const;

  double featureCosine_;
  const CellView* view_ = nullptr;
  const CellShape* shape_ = nullptr;
  JoinSpec spec_;
  std::vector<Plane> planes_; // of faces
  double negligible_ = 0;     // an area; on one plane only, none is
  JoinedFaces joined_;
  std::vector<Part> partOf_;                                   // of faces
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_; // of neighbouring faces
  std::vector<std::uint64_t> edges_;                 // once listed: lower node, higher node, face
  std::vector<std::uint32_t> ring_;                  // tried out
  std::array<std::vector<std::uint32_t>, 2> halves_; // of that
  JoinedShape joinedShape_;
};

}
