// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/ShortEdges.h"

#include "Base/Sorting.h"
#include "Collapse/FaceCompaction.h"
#include "Collapse/ShortEdgeList.h"
#include "Lattice/Vector.h"
#include "Parts/Slabs.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t EdgesAChunk = 1024;
constexpr std::size_t FacesAChunk = 4096;
constexpr std::size_t BoxesAChunk = 1024;

// A chain of short edges takes a round each.
constexpr int MostRounds = 8;

// How far a node may leave the planes of its faces, by the box's shortest edge: smooth surfaces are
// approximated by a few times this; edges of the surface keep their places.
constexpr double SmoothError = 2e-2;
constexpr double FeatureError = 2e-5;

// ... in levels: rounding.
constexpr double RoundingLevels = 0.9;

// A face may tilt by less than 60 degrees, and fold back by this part of its area.
constexpr double LeastTilt = 0.5;
constexpr double RoundingOfAreas = 1e-9;

struct Choice
{
  float length = -1; // or not to collapse now
  bool toB = false;  // a goes to where b is, or b to a
};

class Collapser
{
public:
  Collapser(const Boxes& boxes, const Sides& sides, const ShortEdgeSpec& spec, Patches& patches,
    Nodes& nodes, InnerFaces& inner, Execution& execution)
    : boxes_(boxes)
    , sides_(sides)
    , spec_(spec)
    , patches_(patches)
    , nodes_(nodes)
    , inner_(inner)
    , execution_(execution)
    , featureCosine_(std::cos(radians(spec.featureAngle)))
  {
  }

  std::size_t run()
  {
    execution_.nextLoop(0.3);
    edges_ = listShortEdges(
      { boxes_, sides_, patches_, nodes_, inner_ }, spec_.ratio,
      [&](std::size_t n) { return stays(n); }, execution_);
    if (edges_.empty())
    {
      return 0;
    }
    listFacesOfNodes();
    slotOfNode();
    banKept();
    std::size_t gone = 0;
    for (int round = 0; round < MostRounds; ++round)
    {
      // Where all that was tried was taken back, others are tried next, as elsewhere.
      const std::size_t tried = collapseOnce();
      gone += merges_.size();
      if (tried == 0)
      {
        break;
      }
    }
    if (gone > 0)
    {
      rewrite();
    }
    return gone;
  }

private:
  // What happened to a node: slots are nodes at short edges.
  struct Slot
  {
    std::uint32_t node;
    std::uint32_t into; // slot that it is part of, itself else
    std::uint32_t next; // ring of the slots that are one
    Point at;           // of the slot that stays
  };

  struct FaceOfSlot
  {
    std::uint32_t slot;
    std::uint32_t face;

    bool operator<(const FaceOfSlot& other) const { return face < other.face; }
  };

  struct Merge
  {
    std::uint32_t edge;
    std::uint32_t stays; // slots
    std::uint32_t goes;
    Point before; // where the one that stays was
  };

  // --- faces around nodes

  std::size_t patchCount() const { return patches_.size(); }
  std::size_t faceCount() const { return patches_.size() + inner_.size(); }
  bool isPatch(std::uint32_t face) const { return face < patchCount(); }

  // Begin and end.
  std::array<const std::uint32_t*, 2> cornersOf(std::uint32_t face) const
  {
    const bool patch = isPatch(face);
    const std::size_t f = patch ? face : face - patchCount();
    const std::size_t* const start = (patch ? patches_.start : inner_.start).data() + f;
    const std::uint32_t* const corners = (patch ? patches_.corners : inner_.nodes).data();
    return { corners + start[0], corners + start[1] };
  }

  template <class Visitor>
  void forEachCorner(std::uint32_t face, Visitor&& visit) const
  {
    const auto [begin, end] = cornersOf(face);
    std::for_each(begin, end, visit);
  }

  void listFacesOfNodes()
  {
    slotOf_.assign(nodes_.at.size(), None);
    for (const ShortEdge& edge : edges_)
    {
      slotOf_[edge.a] = slotOf_[edge.b] = 0;
    }
    for (std::uint32_t node = 0; node < slotOf_.size(); ++node)
    {
      if (slotOf_[node] != None)
      {
        const auto slot = static_cast<std::uint32_t>(slots_.size());
        slotOf_[node] = slot;
        slots_.push_back({ node, slot, slot, nodes_.at[node] });
      }
    }
    std::vector<std::vector<FaceOfSlot>> uses(chunks(faceCount(), FacesAChunk));
    execution_.forEach(faceCount(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
      for (auto face = static_cast<std::uint32_t>(begin); face < end; ++face)
      {
        forEachCorner(face, [&](std::uint32_t node) {
          if (slotOf_[node] != None)
          {
            uses[begin / FacesAChunk].push_back({ slotOf_[node], face });
          }
        });
      }
    });
    facesOf_ = sortIntoBuckets(
      uses, slots_.size(), [](const FaceOfSlot& use) { return use.slot; }, execution_);
  }

  void slotOfNode()
  {
    for (ShortEdge& edge : edges_)
    {
      edge.a = slotOf_[edge.a];
      edge.b = slotOf_[edge.b];
    }
  }

  // Edges with an end in a box that keeps its edges.
  void banKept()
  {
    std::vector<std::uint8_t> kept(slots_.size());
    std::vector<std::vector<std::uint32_t>> parts(chunks(sides_.polyhedral.size(), BoxesAChunk));
    execution_.forEach(
      sides_.polyhedral.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
        {
          if (stays(n) && isNearMoving(n))
          {
            listSlotsOfBox(n, parts[begin / BoxesAChunk]);
          }
        }
      });
    for (const std::vector<std::uint32_t>& part : parts)
    {
      for (const std::uint32_t slot : part)
      {
        kept[slot] = 1;
      }
    }
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
    {
      kept[slot] = kept[slot] || isEndOfSlab(slot);
    }
    for (ShortEdge& edge : edges_)
    {
      edge.banned = kept[edge.a] || kept[edge.b];
    }
  }

  // Appends those at the faces of a box; slots may come twice.
  void listSlotsOfBox(std::size_t n, std::vector<std::uint32_t>& slots) const
  {
    const auto list = [&](const auto& start, const auto& corners, std::size_t face) {
      for (std::size_t i = start[face]; i < start[face + 1]; ++i)
      {
        if (slotOf_[corners[i]] != None)
        {
          slots.push_back(slotOf_[corners[i]]);
        }
      }
    };
    const std::uint32_t cut = sides_.patchBox[n];
    for (std::size_t p = cut == None ? 0 : patches_.boxStart[cut];
         cut != None && p < patches_.boxStart[cut + 1]; ++p)
    {
      list(patches_.start, patches_.corners, p);
    }
    for (std::size_t i = sides_.boxStart[n]; i < sides_.boxStart[n + 1]; ++i)
    {
      const std::size_t s = sides_.ofBox[i].side;
      for (std::size_t f = inner_.sideStart[s]; f < inner_.sideStart[s + 1]; ++f)
      {
        list(inner_.start, inner_.nodes, f);
      }
    }
  }

  // Whether a box keeps its edges.
  bool stays(std::size_t n) const { return spec_.keeps[n] || !isMovingLayer(layerOf(n)); }

  // Whether there may be boxes that do not stay around it.
  bool isNearMoving(std::size_t n) const
  {
    const std::uint32_t layer = layerOf(n);
    return isMovingLayer(layer) || isMovingLayer(layer + 1) ||
      (layer > 0 && isMovingLayer(layer - 1));
  }

  std::uint32_t layerOf(std::size_t n) const
  {
    return boxes_.globalOf(boxes_.packed[sides_.polyhedral[n]]).index[2];
  }

  bool isMovingLayer(std::uint32_t layer) const
  {
    return !spec_.acrossSeams || isSeamPlane(layer) || isSeamPlane(layer + 1);
  }

  bool isSeamPlane(std::uint32_t plane) const { return isSeam(plane, boxes_.allLayers().end); }

  // Whether a node lies, or its hexahedra begin, where the layers end that nodes move in.
  bool isEndOfSlab(std::uint32_t slot) const
  {
    const std::uint32_t node = slots_[slot].node;
    const bool isOfGrid = node >= nodes_.patchPoints;
    const Level z = (isOfGrid ? nodes_.grid[node - nodes_.patchPoints] : nodes_.at[node])[2];
    const std::vector<Level>& planes = boxes_.planes[2];
    const auto plane = std::lower_bound(planes.begin(), planes.end(), z);
    if (plane == planes.end() || *plane != z)
    {
      return false;
    }
    const bool onSeam = isSeamPlane(static_cast<std::uint32_t>(plane - planes.begin()));
    return spec_.acrossSeams ? isOfGrid && !onSeam : onSeam;
  }

  // Calls visit(face) for the faces at all nodes that became this one; faces may come twice.
  template <class Visitor>
  void forEachFaceAt(std::uint32_t slot, Visitor&& visit) const
  {
    std::uint32_t s = slot;
    do
    {
      for (const FaceOfSlot* use = facesOf_.begin(s); use != facesOf_.end(s); ++use)
      {
        visit(use->face);
      }
      s = slots_[s].next;
    } while (s != slot);
  }

  // The slot that a slot is part of: what stood at the round's beginning may have gone in it.
  std::uint32_t standing(std::uint32_t slot) const { return slots_[slots_[slot].into].into; }
  std::uint32_t nodeNow(std::uint32_t node) const
  {
    return slotOf_[node] == None ? node : slots_[standing(slotOf_[node])].node;
  }
  const Point& placeOf(std::uint32_t node) const
  {
    return slotOf_[node] == None ? nodes_.at[node] : slots_[standing(slotOf_[node])].at;
  }

  // The corners that are left of a face.
  void ringOf(std::uint32_t face, std::vector<std::uint32_t>& ring) const
  {
    const auto [begin, end] = cornersOf(face);
    ringOf(begin, end, ring);
  }

  void ringOf(
    const std::uint32_t* begin, const std::uint32_t* end, std::vector<std::uint32_t>& ring) const
  {
    ring.clear();
    for (const std::uint32_t* corner = begin; corner != end; ++corner)
    {
      const std::uint32_t now = nodeNow(*corner);
      if (ring.empty() || ring.back() != now)
      {
        ring.push_back(now);
      }
    }
    while (ring.size() > 1 && ring.front() == ring.back())
    {
      ring.pop_back();
    }
  }

  // --- which may collapse

  bool isGridNode(std::uint32_t slot) const { return slots_[slot].node >= nodes_.patchPoints; }

  // Nodes at the end of the grid stay there.
  bool staysOnGrid(const Point& from, const Point& to) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto& planes = boxes_.planes[axis];
      const bool atEnd = from[axis] == planes.front() || from[axis] == planes.back();
      if (atEnd && to[axis] != from[axis])
      {
        return false;
      }
    }
    return true;
  }

  Vector areaOf(const std::vector<std::uint32_t>& ring) const
  {
    Vector twice{ 0, 0, 0 };
    const Point& base = placeOf(ring[0]);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    {
      twice = plus(twice, cross(minus(placeOf(ring[i]), base), minus(placeOf(ring[i + 1]), base)));
    }
    return twice;
  }

  struct Scratch
  {
    std::vector<std::uint32_t> ring;
    std::vector<Vector> normals;
    std::vector<std::pair<std::uint32_t, std::int32_t>> borders; // next node, boundary
    std::vector<std::uint32_t> near;
    std::vector<std::uint32_t> thirds;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> twins;
  };

  // Whether a node may go there.
  bool mayMove(std::uint32_t slot, const Point& to, double unit, Scratch& scratch) const
  {
    const Point& from = slots_[slot].at;
    if (!staysOnGrid(from, to))
    {
      return false;
    }
    scratch.normals.clear();
    scratch.borders.clear();
    double error = 0;
    bool feature = false;
    std::int32_t boundary = NoBoundary;
    forEachFaceAt(slot, [&](std::uint32_t face) {
      if (!isPatch(face))
      {
        return;
      }
      ringOf(face, scratch.ring);
      if (scratch.ring.size() < 3)
      {
        return;
      }
      const Vector normal = cartesian::unit(areaOf(scratch.ring));
      if (dot(normal, normal) == 0)
      {
        return;
      }
      error = std::max(error, std::abs(dot(minus(to, from), normal)));
      feature = feature || (!scratch.normals.empty() && patches_.boundary[face] != boundary);
      boundary = patches_.boundary[face];
      for (const Vector& other : scratch.normals)
      {
        feature = feature || dot(other, normal) < featureCosine_;
      }
      scratch.normals.push_back(normal);
      listBorders(slot, face, scratch);
    });
    error = std::max(error, distanceFromBorders(slot, to, scratch));
    if (spec_.exact)
    {
      return scratch.normals.empty();
    }
    return error <= std::max(RoundingLevels, (feature ? FeatureError : SmoothError) * unit);
  }

  // Notes the boundaries on the edges of a patch, seen along scratch.ring, at a node.
  void listBorders(std::uint32_t slot, std::uint32_t face, Scratch& scratch) const
  {
    const std::vector<std::uint32_t>& ring = scratch.ring;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (ring[i] == slots_[slot].node)
      {
        for (const std::size_t k :
          { i + 1 < ring.size() ? i + 1 : 0, i > 0 ? i - 1 : ring.size() - 1 })
        {
          scratch.borders.emplace_back(ring[k], patches_.boundary[face]);
        }
      }
    }
  }

  // How far a place is from the lines along which two boundaries meet at a node.
  double distanceFromBorders(std::uint32_t slot, const Point& to, Scratch& scratch) const
  {
    auto& borders = scratch.borders;
    std::sort(borders.begin(), borders.end());
    const Vector way = minus(to, slots_[slot].at);
    double distance = 0;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
    {
      if (borders[i].first == borders[i + 1].first && borders[i].second != borders[i + 1].second)
      {
        const Vector along = cartesian::unit(minus(placeOf(borders[i].first), slots_[slot].at));
        distance = std::max(distance, norm(cross(way, along)));
      }
    }
    return distance;
  }

  // Nodes next to both must be the third corner of a triangle: else faces would touch.
  bool closesUp(std::uint32_t a, std::uint32_t b, Scratch& scratch) const
  {
    const std::uint32_t nodeA = slots_[a].node;
    const std::uint32_t nodeB = slots_[b].node;
    scratch.near.clear();
    scratch.thirds.clear();
    const auto forEachNeighbour = [&](std::uint32_t slot, std::uint32_t node, const auto& visit) {
      forEachFaceAt(slot, [&](std::uint32_t face) {
        ringOf(face, scratch.ring);
        const std::vector<std::uint32_t>& ring = scratch.ring;
        for (std::size_t i = 0; ring.size() > 2 && i < ring.size(); ++i)
        {
          if (ring[i] == node)
          {
            visit(ring[i + 1 < ring.size() ? i + 1 : 0]);
            visit(ring[i > 0 ? i - 1 : ring.size() - 1]);
          }
        }
      });
    };
    forEachFaceAt(a, [&](std::uint32_t face) {
      ringOf(face, scratch.ring);
      const bool has =
        std::find(scratch.ring.begin(), scratch.ring.end(), nodeB) != scratch.ring.end();
      for (std::size_t i = 0; has && scratch.ring.size() == 3 && i < 3; ++i)
      {
        scratch.thirds.push_back(scratch.ring[i]);
      }
    });
    forEachNeighbour(a, nodeA, [&](std::uint32_t node) { scratch.near.push_back(node); });
    bool good = true;
    forEachNeighbour(b, nodeB, [&](std::uint32_t node) {
      const auto& thirds = scratch.thirds;
      good = good &&
        (node == nodeA ||
          std::find(scratch.near.begin(), scratch.near.end(), node) == scratch.near.end() ||
          std::find(thirds.begin(), thirds.end(), node) != thirds.end());
    });
    return good;
  }

  Choice choose(const ShortEdge& edge, Scratch& scratch) const
  {
    Choice choice;
    const std::uint32_t a = slots_[edge.a].into;
    const std::uint32_t b = slots_[edge.b].into;
    if (edge.banned || a == b || (isGridNode(a) && isGridNode(b)))
    {
      return choice;
    }
    const double length = norm(minus(slots_[a].at, slots_[b].at));
    if (length >= spec_.ratio * edge.unit)
    {
      return choice;
    }
    // Nodes off the surface go first.
    const bool toB = mayMove(a, slots_[b].at, edge.unit, scratch);
    const bool toA = mayMove(b, slots_[a].at, edge.unit, scratch);
    if ((!toA && !toB) || !closesUp(a, b, scratch))
    {
      return choice;
    }
    choice.length = static_cast<float>(length);
    choice.toB = toA && toB ? prefersB(a, b) : toB;
    return choice;
  }

  // Where both may move: the grid's node, else the one at the lower place.
  bool prefersB(std::uint32_t a, std::uint32_t b) const
  {
    if (isGridNode(a) != isGridNode(b))
    {
      return isGridNode(a);
    }
    return slots_[a].at < slots_[b].at;
  }

  // --- a round: each node takes part in its shortest edge only; how many are tried

  std::size_t collapseOnce()
  {
    choices_.assign(edges_.size(), {});
    execution_.nextLoop(0.3);
    execution_.forEach(edges_.size(), EdgesAChunk, [&](std::size_t begin, std::size_t end) {
      Scratch scratch;
      for (std::size_t i = begin; i < end; ++i)
      {
        choices_[i] = choose(edges_[i], scratch);
      }
    });
    pickMerges();
    const std::size_t tried = merges_.size();
    for (const Merge& merge : merges_)
    {
      swapRings(merge);
    }
    takeBackBadOnes();
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
    {
      slots_[slot].into = standing(slot);
    }
    return tried;
  }

  bool isBefore(std::uint32_t i, std::uint32_t k) const
  {
    if (choices_[i].length != choices_[k].length)
    {
      return choices_[i].length < choices_[k].length;
    }
    const auto ends = [&](std::uint32_t e) {
      const Point& p = slots_[slots_[edges_[e].a].into].at;
      const Point& q = slots_[slots_[edges_[e].b].into].at;
      return std::make_pair(std::min(p, q), std::max(p, q));
    };
    const auto x = ends(i);
    const auto y = ends(k);
    return x != y ? x < y : i < k;
  }

  void pickMerges()
  {
    std::vector<std::uint32_t> best(slots_.size(), None);
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
    {
      if (choices_[e].length < 0)
      {
        continue;
      }
      for (const std::uint32_t slot : { slots_[edges_[e].a].into, slots_[edges_[e].b].into })
      {
        best[slot] = best[slot] == None || isBefore(e, best[slot]) ? e : best[slot];
      }
    }
    merges_.clear();
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
    {
      const std::uint32_t a = slots_[edges_[e].a].into;
      const std::uint32_t b = slots_[edges_[e].b].into;
      if (choices_[e].length < 0 || best[a] != e || best[b] != e)
      {
        continue;
      }
      // Boxes refer to their corners: such a node stays, at the other's place.
      const bool aStays = isGridNode(a) || (!isGridNode(b) && !choices_[e].toB);
      const std::uint32_t stays = aStays ? a : b;
      merges_.push_back({ e, stays, aStays ? b : a, slots_[stays].at });
      slots_[stays].at = slots_[choices_[e].toB ? b : a].at;
      slots_[merges_.back().goes].into = stays;
    }
  }

  // Joins the rings of both, or parts them again.
  void swapRings(const Merge& merge)
  {
    std::swap(slots_[merge.stays].next, slots_[merge.goes].next);
  }

  // Faces that turned over take back all that moved their corners, until none is left.
  void takeBackBadOnes()
  {
    std::vector<std::uint32_t> mergeAt(slots_.size(), None);
    for (std::uint32_t m = 0; m < merges_.size(); ++m)
    {
      mergeAt[merges_[m].stays] = m;
    }
    std::vector<std::uint8_t> bad(merges_.size());
    for (bool any = true; any;)
    {
      bad.assign(merges_.size(), 0);
      std::vector<std::vector<std::uint32_t>> parts(chunks(merges_.size(), EdgesAChunk));
      execution_.nextLoop(0.1);
      execution_.forEach(merges_.size(), EdgesAChunk, [&](std::size_t begin, std::size_t end) {
        Scratch scratch;
        for (std::size_t m = begin; m < end; ++m)
        {
          if (merges_[m].edge != None)
          {
            listBad(merges_[m].stays, mergeAt, scratch, parts[begin / EdgesAChunk]);
          }
        }
      });
      any = false;
      for (const auto& part : parts)
      {
        for (const std::uint32_t m : part)
        {
          any = true;
          bad[m] = 1;
        }
      }
      for (std::uint32_t m = 0; m < merges_.size(); ++m)
      {
        if (bad[m])
        {
          takeBack(merges_[m], mergeAt);
        }
      }
    }
    merges_.erase(std::remove_if(merges_.begin(), merges_.end(),
                    [](const Merge& merge) { return merge.edge == None; }),
      merges_.end());
  }

  void takeBack(Merge& merge, std::vector<std::uint32_t>& mergeAt)
  {
    swapRings(merge);
    slots_[merge.stays].at = merge.before;
    slots_[merge.goes].into = merge.goes;
    mergeAt[merge.stays] = None;
    edges_[merge.edge].banned = true;
    merge.edge = None;
  }

  void listBad(std::uint32_t slot, const std::vector<std::uint32_t>& mergeAt, Scratch& scratch,
    std::vector<std::uint32_t>& bad) const
  {
    std::vector<std::uint32_t>& ring = scratch.ring;
    const auto note = [&] {
      for (const std::uint32_t node : ring)
      {
        const std::uint32_t s = slotOf_[node];
        if (s != None && mergeAt[s] != None)
        {
          bad.push_back(mergeAt[s]);
        }
      }
    };
    scratch.twins.clear();
    forEachFaceAt(slot, [&](std::uint32_t face) {
      ringOf(face, ring);
      if (!isGood(face, ring))
      {
        note();
      }
      else if (ring.size() > 2)
      {
        scratch.twins.emplace_back(keyOf(ring), face);
      }
    });
    // A cell that is flat goes with a patch on one of its sides: between two inner faces it would
    // leave a wall.
    auto& twins = scratch.twins;
    std::sort(twins.begin(), twins.end());
    twins.erase(std::unique(twins.begin(), twins.end()), twins.end());
    for (std::size_t i = 0; i + 1 < twins.size(); ++i)
    {
      if (twins[i].first == twins[i + 1].first &&
        isPatch(twins[i].second) == isPatch(twins[i + 1].second))
      {
        ringOf(twins[i].second, ring);
        note();
      }
    }
  }

  // The same for faces with the same corners, however they run.
  static std::uint64_t keyOf(const std::vector<std::uint32_t>& ring)
  {
    std::uint64_t sum = 0;
    for (const std::uint32_t node : ring)
    {
      std::uint64_t bits = (node + 1) * 0x9e3779b97f4a7c15u;
      bits = (bits ^ (bits >> 29)) * 0xbf58476d1ce4e5b9u;
      sum += bits ^ (bits >> 32);
    }
    return sum;
  }

  // Whether a face is gone, or a star that looks where it did.
  bool isGood(std::uint32_t face, const std::vector<std::uint32_t>& ring) const
  {
    if (ring.size() < 3)
    {
      return true;
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (std::find(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, ring.end(), ring[i]) !=
        ring.end())
      {
        return false;
      }
    }
    const Vector before = originalArea(face);
    const Vector now = areaOf(ring);
    const double size = norm(now);
    if (!(dot(before, now) > LeastTilt * norm(before) * size))
    {
      return false;
    }
    Vector mean{ 0, 0, 0 };
    const Point& origin = placeOf(ring[0]);
    for (const std::uint32_t node : ring)
    {
      mean = plus(mean, minus(placeOf(node), origin));
    }
    mean = scaled(mean, 1.0 / static_cast<double>(ring.size()));
    double least = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Vector p = minus(minus(placeOf(ring[i]), origin), mean);
      const Vector q = minus(minus(placeOf(ring[i + 1 < ring.size() ? i + 1 : 0]), origin), mean);
      least = std::min(least, dot(cross(p, q), now));
    }
    return least >= -RoundingOfAreas * size * size;
  }

  Vector originalArea(std::uint32_t face) const
  {
    Vector twice{ 0, 0, 0 };
    std::uint32_t first = None;
    std::uint32_t before = None;
    forEachCorner(face, [&](std::uint32_t node) {
      if (first == None)
      {
        first = node;
      }
      else if (before != None)
      {
        twice = plus(twice,
          cross(
            minus(nodes_.at[before], nodes_.at[first]), minus(nodes_.at[node], nodes_.at[first])));
      }
      before = node;
    });
    return twice;
  }

  // --- writing

  void rewrite()
  {
    const auto whatIsLeft = [&](const std::uint32_t* begin, const std::uint32_t* end,
                              std::vector<std::uint32_t>& ring) { ringOf(begin, end, ring); };
    compactFaces(
      patches_.boxStart, patches_.start, patches_.corners, whatIsLeft,
      [&](std::size_t from, std::size_t to) {
        patches_.triangle[to] = patches_.triangle[from];
        patches_.boundary[to] = patches_.boundary[from];
      },
      execution_);
    patches_.triangle.resize(patches_.start.size() - 1);
    patches_.boundary.resize(patches_.start.size() - 1);
    compactFaces(
      inner_.sideStart, inner_.start, inner_.nodes, whatIsLeft, [](std::size_t, std::size_t) {},
      execution_);
    for (const Slot& slot : slots_)
    {
      nodes_.at[slot.node] = slots_[slot.into].at;
    }
  }

  const Boxes& boxes_;
  const Sides& sides_;
  const ShortEdgeSpec& spec_;
  Patches& patches_;
  Nodes& nodes_;
  InnerFaces& inner_;
  Execution& execution_;
  double featureCosine_;
  std::vector<ShortEdge> edges_;      // ends: nodes, then slots
  std::vector<Choice> choices_;       // of each edge
  std::vector<Merge> merges_;         // of this round
  std::vector<std::uint32_t> slotOf_; // of nodes, or None
  std::vector<Slot> slots_;
  Buckets<FaceOfSlot> facesOf_; // of slots
};

}

std::size_t collapseShortEdges(const Boxes& boxes, const Sides& sides, const ShortEdgeSpec& spec,
  Patches& patches, Nodes& nodes, InnerFaces& inner, Execution& execution)
{
  return Collapser(boxes, sides, spec, patches, nodes, inner, execution).run();
}

}
