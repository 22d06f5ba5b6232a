// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/NodeKinds.h"

#include "Editing/MeshEditor.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr double NoArea = 1e-5;          // of a box's side: the direction of such a face is noise
constexpr double StraightCosine = -0.9;  // between the two sharp edges at a node within one
constexpr double MostDisplacement = 0.4; // in boxes
constexpr double Sagitta =
  0.012; // in boxes: how far a node may leave the surface on its maxDisplacement
constexpr double LeastSine = 1e-3;

constexpr std::size_t NodesAChunk = 1024;

// A face of the wall at a node.
struct Use
{
  Vector normal;
  double area; // of a box's side
  std::int32_t wall;
  std::array<std::uint32_t, 2> ends; // of its edges at the node: before it and behind it
};

class KindOfNode
{
public:
  KindOfNode(MeshEditor& mesh, const KnownKinds& kinds, double featureAngle)
    : mesh_(mesh)
    , kinds_(kinds)
    , featureCosine_(std::cos(radians(featureAngle)))
  {
  }

  void find(std::uint32_t n)
  {
    list(n);
    EditNode& node = mesh_.rawNode(n);
    const PointKind known = kinds_.of(node.number);
    node.referencePosition = node.at;
    const bool isSheet = listSharp(known) && isOneFan();
    if (uses_.empty())
    {
      return;
    }
    node.along = unit(mean());
    if (isSheet &&
      (sharp_.empty() || (sharp_.size() == 1 && !kinds_.knowsEdges && isFlat(node.along)) ||
        (known == PointKind::OnSurface && !isBorder_)))
    {
      node.kind = NodeKind::OnSurface;
      node.maxDisplacement = static_cast<float>(maxDisplacement(node.along) * edge_);
      return;
    }
    node.kind = NodeKind::Corner;
    if (sharp_.size() == 2 && isClosed_)
    {
      const Vector a = unit(minus(mesh_.node(sharp_[0]).at, node.at));
      const Vector b = unit(minus(mesh_.node(sharp_[1]).at, node.at));
      // At an end of the grid, only the mesh knows whether the edge goes on straight.
      const bool isKnown =
        node.constrainedAxes == 0 && (known == PointKind::OnEdge || known == PointKind::Corner);
      const bool isStraight = isKnown ? known == PointKind::OnEdge
                                      : known != PointKind::Corner && dot(a, b) < StraightCosine;
      node.kind = isStraight ? NodeKind::OnEdge : NodeKind::Corner;
      node.along = unit(minus(a, b));
    }
  }

private:
  void list(std::uint32_t n)
  {
    uses_.clear();
    edge_ = 0;
    for (const std::uint32_t f : mesh_.facesAround(n))
    {
      const EditFace& face = mesh_.face(f);
      const bool isBetween = !mesh_.isWall(f) && face.wall >= 0;
      if (!mesh_.isWall(f) && !isBetween)
      {
        continue;
      }
      const Items corners = mesh_.cornersOf(f);
      const std::size_t size = corners.size();
      const auto i =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), n) - corners.begin());
      const EditCell& cell = mesh_.cell(face.below);
      edge_ = uses_.empty() ? cell.edge : std::min(edge_, cell.edge);
      uses_.push_back({ unit(face.area), norm(face.area) / (cell.edge * cell.edge), face.wall,
        { corners[(i + size - 1) % size], corners[(i + 1) % size] } });
    }
  }

  // `known`: the kind of the node. False: an edge has other than two faces.
  bool listSharp(PointKind known)
  {
    sharp_.clear();
    isClosed_ = true;
    isBorder_ = false;
    ends_.clear();
    for (const Use& use : uses_)
    {
      ends_.insert(ends_.end(), use.ends.begin(), use.ends.end());
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (const std::uint32_t end : ends_)
    {
      if (isSharp(end, known))
      {
        sharp_.push_back(end);
      }
    }
    return isClosed_;
  }

  // Whether an edge of the wall is sharp, by what its ends are on if that is known, else by its angle.
  bool turns(double cosine, std::uint32_t end, PointKind known) const
  {
    const PointKind lower = std::min(known, kinds_.of(mesh_.node(end).number));
    return kinds_.knowsEdges && lower != PointKind::OffSurface
      ? lower >= PointKind::OnEdge && cosine < SharpRule::OfOnePlane
      : cosine < featureCosine_;
  }

  bool isSharp(std::uint32_t end, PointKind known)
  {
    std::array<const Use*, 2> at{};
    std::size_t count = 0;
    for (const Use& use : uses_)
    {
      if (use.ends[0] == end || use.ends[1] == end)
      {
        at[std::min<std::size_t>(count, 1)] = &use;
        ++count;
      }
    }
    if (count != 2)
    {
      isClosed_ = isClosed_ && count > 2; // where regions meet, an edge has three faces
      isBorder_ = true;
      return true;
    }
    // Of a wall between regions one face may look the other way.
    const bool areAlike = (at[0]->ends[0] == end) != (at[1]->ends[0] == end);
    const double cosine = dot(at[0]->normal, at[1]->normal) * (areAlike ? 1 : -1);
    isBorder_ = isBorder_ || at[0]->wall != at[1]->wall;
    return at[0]->wall != at[1]->wall ||
      (turns(cosine, end, known) && at[0]->area > NoArea && at[1]->area > NoArea);
  }

  // Whether all faces are connected by edges at the node.
  bool isOneFan()
  {
    if (uses_.empty())
    {
      return false;
    }
    reached_.assign(1, 0);
    std::vector<std::uint8_t>& seen = seen_;
    seen.assign(uses_.size(), 0);
    seen[0] = 1;
    for (std::size_t i = 0; i < reached_.size(); ++i)
    {
      for (std::size_t j = 0; j < uses_.size(); ++j)
      {
        const auto& a = uses_[reached_[i]].ends;
        const auto& b = uses_[j].ends;
        const bool touch = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
        if (touch && !seen[j])
        {
          seen[j] = 1;
          reached_.push_back(j);
        }
      }
    }
    return reached_.size() == uses_.size();
  }

  Vector mean() const
  {
    Vector sum{};
    for (const Use& use : uses_)
    {
      sum = plus(sum, scaled(use.normal, use.area));
    }
    return sum;
  }

  bool isFlat(const Vector& along) const
  {
    return std::all_of(uses_.begin(), uses_.end(),
      [&](const Use& use) { return !(dot(use.normal, along) < featureCosine_); });
  }

  // The more the wall is curved, the shorter.
  double maxDisplacement(const Vector& along) const
  {
    constexpr double LeastArea = 1e-3; // of a box's side
    double sine = LeastSine;
    for (const Use& use : uses_)
    {
      const double cosine = std::min(1.0, std::abs(dot(use.normal, along)));
      sine = use.area > LeastArea ? std::max(sine, std::sqrt(1 - cosine * cosine)) : sine;
    }
    return std::min(MostDisplacement, Sagitta / sine);
  }

  MeshEditor& mesh_;
  const KnownKinds& kinds_;
  double featureCosine_;
  std::vector<Use> uses_;
  std::vector<std::uint32_t> ends_;
  std::vector<std::uint32_t> sharp_; // ends of sharp edges
  std::vector<std::size_t> reached_;
  std::vector<std::uint8_t> seen_;
  double edge_ = 0; // of the smallest box
  bool isClosed_ = true;
  bool isBorder_ = false; // two walls meet, also where one is an end of the grid
};

}

void findNodeKinds(
  EditMesh& whole, const KnownKinds& known, double featureAngle, Execution& execution)
{
  execution.forEach(whole.nodes.size(), NodesAChunk, [&](std::size_t begin, std::size_t end) {
    MeshEditor mesh(whole, 0, 0, {});
    KindOfNode kind(mesh, known, featureAngle);
    for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n)
    {
      if (mesh.node(n).atWall)
      {
        kind.find(n);
      }
    }
  });
}

}
