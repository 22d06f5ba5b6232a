// SPDX-License-Identifier: BSD-3-Clause
#include "CadBodies.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// Edges by their places: sewing pairs four that meet in one line, in whatever way.
class EdgePlaces
{
public:
  std::size_t numberOf(const TopoDS_Edge& edge)
  {
    const int count = edges_.Extent();
    const int index = edges_.Add(edge);
    if (index <= count)
    {
      return numbers_[static_cast<std::size_t>(index - 1)];
    }
    const Place place = placeOf(edge);
    largest_ = std::max(largest_, place.near);
    const double x = place.points[0].X();
    const auto end = places_.upper_bound(x + place.near + largest_);
    const auto same = std::find_if(places_.lower_bound(x - place.near - largest_), end,
      [&](const auto& other) { return areSame(place, other.second); });
    numbers_.push_back(same == end ? count_++ : same->second.number);
    places_.emplace(x, place)->second.number = numbers_.back();
    return numbers_.back();
  }

private:
  struct Place
  {
    std::array<gp_Pnt, 3> points; // halfway along it, however it is parametrized, and its ends
    double near = 0;              // how exact the edge is
    std::size_t number = 0;
  };

  static Place placeOf(const TopoDS_Edge& edge)
  {
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter();
    const double half = GCPnts_AbscissaPoint::Length(curve) / 2;
    Place place;
    place.points = { curve.Value(GCPnts_AbscissaPoint(curve, half, first).Parameter()),
      curve.Value(first), curve.Value(curve.LastParameter()) };
    place.near = BRep_Tool::Tolerance(edge);
    for (const TopoDS_Vertex& end : { TopExp::FirstVertex(edge), TopExp::LastVertex(edge) })
    {
      place.near = std::max(place.near, end.IsNull() ? 0 : BRep_Tool::Tolerance(end));
    }
    return place;
  }

  static bool areSame(const Place& a, const Place& b)
  {
    const auto isNear = [&](std::size_t i, std::size_t k) {
      return a.points[i].Distance(b.points[k]) <= a.near + b.near;
    };
    return isNear(0, 0) && ((isNear(1, 1) && isNear(2, 2)) || (isNear(1, 2) && isNear(2, 1)));
  }

  TopTools_IndexedMapOfShape edges_;
  std::vector<std::size_t> numbers_;    // of edges
  std::multimap<double, Place> places_; // by x
  double largest_ = 0;                  // of Place::near
  std::size_t count_ = 0;
};

class Bodies
{
public:
  explicit Bodies(const std::vector<TopoDS_Shape>& faces)
    : edgesOf_(faces.size())
    , isTaken_(faces.size())
  {
    EdgePlaces places;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      // A seam is passed twice.
      for (TopExp_Explorer edge(faces[f], TopAbs_EDGE); edge.More(); edge.Next())
      {
        if (!BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())) &&
          edge.Current().Orientation() != TopAbs_INTERNAL)
        {
          const std::size_t e = places.numberOf(TopoDS::Edge(edge.Current()));
          facesAt_.resize(std::max(facesAt_.size(), e + 1));
          facesAt_[e].push_back(f);
          edgesOf_[f].push_back(e);
        }
      }
    }
  }

  bool mayBeSeveral() const
  {
    return std::any_of(
      facesAt_.begin(), facesAt_.end(), [](const auto& faces) { return faces.size() > 2; });
  }

  // Closed sets of faces; what is left.
  std::vector<std::vector<std::size_t>> find()
  {
    std::vector<std::vector<std::size_t>> bodies;
    std::vector<std::size_t> left;
    for (std::size_t f = 0; f < isTaken_.size(); ++f)
    {
      if (!isTaken_[f])
      {
        const bool isClosed = grow(f);
        std::vector<std::size_t> body(body_.begin(), body_.end());
        left.insert(left.end(), isClosed ? body.end() : body.begin(), body.end());
        if (isClosed)
        {
          bodies.push_back(std::move(body));
        }
      }
    }
    if (!left.empty())
    {
      bodies.push_back(std::move(left));
    }
    return bodies;
  }

private:
  void take(std::size_t face)
  {
    isTaken_[face] = true;
    body_.insert(face);
    for (const std::size_t e : edgesOf_[face])
    {
      if (!open_.insert(e).second)
      {
        open_.erase(e);
      }
    }
  }

  // From one face; false if it does not close.
  bool grow(std::size_t first)
  {
    body_.clear();
    open_.clear();
    take(first);
    while (!open_.empty())
    {
      std::size_t next = isTaken_.size();
      for (const std::size_t e : open_)
      {
        const std::size_t face = nearestAt(e);
        if (face == isTaken_.size())
        {
          return false;
        }
        if (facesAt_[e].size() == 2)
        {
          next = face;
          break;
        }
        next = next == isTaken_.size() || distanceTo(face) < distanceTo(next) ? face : next;
      }
      take(next);
    }
    return true;
  }

  // The face at an edge that no body has; none: how many there are.
  std::size_t nearestAt(std::size_t edge) const
  {
    std::size_t nearest = isTaken_.size();
    for (const std::size_t f : facesAt_[edge])
    {
      if (!isTaken_[f] && (nearest == isTaken_.size() || distanceTo(f) < distanceTo(nearest)))
      {
        nearest = f;
      }
    }
    return nearest;
  }

  // In order, to the body; the body's own span is 0 away.
  std::size_t distanceTo(std::size_t face) const
  {
    const std::size_t low = *body_.begin();
    const std::size_t high = *body_.rbegin();
    return face < low ? low - face : face > high ? face - high : 0;
  }

  std::vector<std::vector<std::size_t>> facesAt_; // each edge, as often as they pass it
  std::vector<std::vector<std::size_t>> edgesOf_; // each face
  std::vector<bool> isTaken_;
  std::set<std::size_t> body_;
  std::set<std::size_t> open_; // edges that the body's faces pass an odd number of times
};

}

std::vector<std::vector<std::size_t>> bodiesOf(const std::vector<TopoDS_Shape>& faces)
{
  Bodies bodies(faces);
  return bodies.mayBeSeveral() ? bodies.find() : std::vector<std::vector<std::size_t>>();
}

}
