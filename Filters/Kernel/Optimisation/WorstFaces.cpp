// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/WorstFaces.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr double Never = std::numeric_limits<double>::infinity();

// FaceEnergy::limits from which on a face is mended: a skewness of 1.8.
constexpr double PoorLimits = 1.5;

// Likewise where layers will stand, many of whose faces are a bit off: a skewness of 3.1.
constexpr double PoorLimitsWithLayers = 15;

// From here on all nodes of its cells are moved: a skewness of 4.
constexpr double FailingLimits = 39;

// What changes more faces is left as it is: the time for an edit grows with them.
constexpr std::size_t MostFacesAround = 300;

// What has changed is looked at again, so often at most.
constexpr int MostSweeps = 3;

// Of a node that moves: the longest step, as a part of the box's edge.
constexpr double LongestStep = 0.1;
constexpr double Shorter = 0.4;
constexpr int MostSteps = 6;

// The least gain, as a part of the objective.
constexpr double LeastGain = 0.01;

// Nodes that are nearer to each other than this part of the box's edge become one.
constexpr double LongestCollapsed = 0.4;

// Faces inside are joined up to 45 degrees; no face of the wall turns by more than 15.
constexpr double InnerCosine = 0.707;
constexpr double LeastTurnedCosine = 0.966;

// ... nor comes farther from where the middle of one that it replaces was, as a part of the box's edge.
constexpr double FarthestFromWall = 0.02;

// The smallest triangle of the star of a face that an edit makes, by the mean one, unless it was smaller.
constexpr double LeastStar = 0.05;

// ... and its area, by the square of the box's edge, likewise.
constexpr double LeastArea = 1e-4;

// What a part of the box that an edit adds to the mesh, or takes from it, costs: a thousandth as much as a face that is
// just fair.
constexpr double CostOfVolume = 1000;

struct Edit
{
  enum class Kind
  {
    Collapse, // of node `one` into `other`
    Join      // of faces
  };
  Kind kind;
  std::uint32_t one;
  std::uint32_t other;
};

class Mender
{
public:
  Mender(const MendingTask& task, MeshEnergy& energy, Execution& execution)
    : task_(task)
    , m_(task.mesh)
    , energy_(energy)
    , execution_(execution)
    , faces_(task.mesh)
    , edgeOf_(m_.nodes.at.size(), Never)
    , changedAt_(m_.cells.changing)
    , lookedAtFace_(m_.faces.size())
    , lookedAtNode_(m_.nodes.at.size())
  {
    for (std::uint32_t f = 0; f < m_.faces.size(); ++f)
    {
      m_.forEachCorner(
        f, [&](std::uint32_t n) { edgeOf_[n] = std::min(edgeOf_[n], task.edges[f]); });
    }
    for (std::size_t i = 0; i < task.prisms.below.size(); ++i)
    {
      topOf_.resize(m_.nodes.at.size(), None);
      topOf_[task.prisms.below[i]] = static_cast<std::uint32_t>(task.prisms.firstNode + i);
    }
  }

  std::vector<FaceEdit> run()
  {
    bool gains = true;
    for (int sweep = 0; gains && sweep < MostSweeps; ++sweep)
    {
      gains = false;
      for (const auto& [rank, f] : poorFaces())
      {
        execution_.poll();
        if (!faces_.isGone(f) && hasChanged(m_.faces.cells[f], lookedAtFace_[f]))
        {
          const std::uint32_t begin = ++now_;
          gains = mend(f) || gains;
          lookedAtFace_[f] = begin;
        }
      }
    }
    return faces_.edits();
  }

private:
  bool isPoor(std::uint32_t f) const
  {
    return energy_.ofFaces()[f].limits > (topOf_.empty() ? PoorLimits : PoorLimitsWithLayers) ||
      energy_.isFolded(f);
  }

  std::vector<std::pair<float, std::uint32_t>> poorFaces() const
  {
    std::vector<std::pair<float, std::uint32_t>> worst;
    for (std::uint32_t f = 0; f < m_.faces.size(); ++f)
    {
      if (!faces_.isGone(f) && isPoor(f))
      {
        worst.emplace_back(-static_cast<float>(energy_.ofFaces()[f].limits), f);
      }
    }
    std::sort(worst.begin(), worst.end());
    return worst;
  }

  bool mend(std::uint32_t f)
  {
    around_.faces = { f };
    faces_.lookAround(around_);
    if (around_.facesOfCells.size() > MostFacesAround || isFailingBetweenRegions())
    {
      return false;
    }
    nodes_.clear();
    m_.forEachCorner(f, [&](std::uint32_t node) { nodes_.push_back(node); });
    bool gains = moveAll();
    if (topOf_.empty())
    {
      gains = (isPoor(f) && editBest(f)) || gains;
      gains = (!faces_.isGone(f) && isFailing(f) && moveCellsOf(f)) || gains;
    }
    return gains;
  }

  bool isFailing(std::uint32_t f) const { return energy_.ofFaces()[f].limits > FailingLimits; }

  // All nodes of its cells.
  bool moveCellsOf(std::uint32_t f)
  {
    nodes_.clear();
    around_.faces = { f };
    faces_.lookAround(around_);
    for (const std::uint32_t other : around_.facesOfCells)
    {
      m_.forEachCorner(other, [&](std::uint32_t node) { nodes_.push_back(node); });
    }
    nodes_ = sortedUnique(std::move(nodes_));
    return moveAll();
  }

  // Such a cell cannot be left out: a cut has to make it valid, and would fail once its nodes have moved.
  bool isFailingBetweenRegions() const
  {
    const std::vector<std::uint32_t>& faces = around_.facesOfCells;
    return std::any_of(
             faces.begin(), faces.end(), [&](std::uint32_t f) { return m_.isInterface(f); }) &&
      std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return isFailing(f); });
  }

  bool moveAll()
  {
    bool gains = false;
    for (const std::uint32_t node : nodes_)
    {
      gains = (isMovable(node) && move(node)) || gains;
    }
    return gains;
  }

  bool isMovable(std::uint32_t n) const
  {
    return n < task_.prisms.firstNode && m_.nodes.mayMove[n] &&
      task_.paths[n].kind != NodePath::Kind::Fixed;
  }

  // --- what has changed

  template <class Cells>
  bool hasChanged(const Cells& cells, std::uint32_t since) const
  {
    return std::any_of(cells.begin(), cells.end(),
      [&](std::uint32_t c) { return c < m_.cells.changing && changedAt_[c] >= since; });
  }

  void markChanged()
  {
    ++now_;
    for (const std::uint32_t c : around_.cells)
    {
      changedAt_[c] = now_;
    }
  }

  // --- moves

  void put(std::uint32_t n, const Vector& at)
  {
    m_.nodes.at[n] = at;
    if (const std::uint32_t top = topOf_.empty() ? std::uint32_t(None) : topOf_[n]; top != None)
    {
      m_.nodes.at[top] = plus(at, task_.prisms.offset[top - task_.prisms.firstNode]);
    }
  }

  bool mayBeAt(std::uint32_t n, const Vector& to) const
  {
    return task_.paths.allows(n, task_.before[n], to, edgeOf_[n]);
  }

  void setFaces(const NumberLists::List& faces)
  {
    around_.faces.assign(faces.begin(), faces.end());
  }

  void lookAroundNode(std::uint32_t n)
  {
    setFaces(faces_.facesOf(n));
    if (const std::uint32_t top = topOf_.empty() ? std::uint32_t(None) : topOf_[n]; top != None)
    {
      const NumberLists::List others = faces_.facesOf(top);
      around_.faces.insert(around_.faces.end(), others.begin(), others.end());
      around_.faces = sortedUnique(std::move(around_.faces));
    }
    faces_.lookAround(around_);
  }

  // Against the derivative as long as that helps.
  bool move(std::uint32_t n)
  {
    lookAroundNode(n);
    if (around_.facesOfCells.size() > MostFacesAround ||
      !hasChanged(around_.cells, lookedAtNode_[n]))
    {
      return false;
    }
    lookedAtNode_[n] = ++now_;
    double now = energy_.evaluate(around_, Never);
    double step = LongestStep * edgeOf_[n];
    bool gains = false;
    for (int i = 0; i < MostSteps && stepDown(n, step, now); ++i)
    {
      gains = true;
    }
    return gains;
  }

  // One step along the node's path, as long as `step` or shorter; whether the objective, `now`, falls.
  bool stepDown(std::uint32_t n, double& step, double& now)
  {
    const Vector down = task_.paths[n].along(scaled(energy_.derivative(around_, n), -1));
    const double length = norm(down);
    const Vector from = m_.nodes.at[n];
    energy_.keep(around_, kept_);
    for (; length * step > LeastGain * now; step *= Shorter)
    {
      const Vector to = rounded(plus(from, scaled(down, step / length)));
      if (!mayBeAt(n, to))
      {
        continue;
      }
      put(n, to);
      const double most = (1 - LeastGain) * now;
      const double there = energy_.evaluate(around_, most);
      if (there < most)
      {
        now = there;
        markChanged();
        return true;
      }
    }
    put(n, from);
    energy_.putBack(around_, kept_);
    return false;
  }

  // --- edits

  bool editBest(std::uint32_t f)
  {
    listEdits(f);
    double best = 0;
    const Edit* chosen = nullptr;
    for (const Edit& edit : edits_)
    {
      const double gain = mayBe(edit) ? tryOut(edit) : 0;
      if (gain > 0)
      {
        takeBack();
      }
      if (gain > best)
      {
        best = gain;
        chosen = &edit;
      }
    }
    if (chosen)
    {
      tryOut(*chosen);
      faces_.commit();
      markChanged();
    }
    return chosen != nullptr;
  }

  void listEdits(std::uint32_t f)
  {
    edits_.clear();
    const std::size_t size = m_.faces.stop[f] - m_.faces.start[f];
    const auto corner = [&](
                          std::size_t i) { return m_.faces.corners[m_.faces.start[f] + i % size]; };
    const auto addPair = [&](std::uint32_t a, std::uint32_t b) {
      if (norm(minus(m_.nodes.at[a], m_.nodes.at[b])) < LongestCollapsed * task_.edges[f])
      {
        edits_.push_back({ Edit::Kind::Collapse, a, b });
        edits_.push_back({ Edit::Kind::Collapse, b, a });
      }
    };
    for (std::size_t i = 0; i < size; ++i)
    {
      addPair(corner(i), corner(i + 1));
    }
    for (std::size_t i = 0; size == 4 && i < 2; ++i) // across
    {
      addPair(corner(i), corner(i + 2));
    }
    const auto& [below, above] = m_.faces.cells[f];
    const std::uint32_t c = below < m_.cells.changing ? below : above;
    for (std::uint32_t u = m_.cells.firstUse[c]; u < m_.cells.endUse[c]; ++u)
    {
      if (m_.cells.uses[u] != f)
      {
        edits_.push_back({ Edit::Kind::Join, f, m_.cells.uses[u] });
      }
    }
  }

  bool mayBe(const Edit& edit) const
  {
    return edit.kind == Edit::Kind::Join ? mayJoin(edit.one, edit.other)
                                         : mayCollapse(edit.one, edit.other);
  }

  bool mayJoin(std::uint32_t f, std::uint32_t g) const
  {
    if (!faces_.areBetweenTheSame(f, g) || !faces_.mayChange(f) || !faces_.mayChange(g))
    {
      return false;
    }
    const double sign = m_.faces.cells[f] == m_.faces.cells[g] ? 1 : -1;
    return sign * dot(unit(energy_.measures(f).area), unit(energy_.measures(g).area)) >=
      (m_.isWall(f) ? task_.featureCosine : InnerCosine);
  }

  // Nodes of the wall only along a face of it: elsewhere two walls would meet.
  bool mayCollapse(std::uint32_t from, std::uint32_t into) const
  {
    const NumberLists::List faces = faces_.facesOf(from);
    return isMovable(from) && m_.nodes.mayMove[into] &&
      std::all_of(
        faces.begin(), faces.end(), [&](std::uint32_t f) { return faces_.mayChange(f); }) &&
      (task_.paths[from].kind == NodePath::Kind::Free ||
        (mayBeAt(from, m_.nodes.at[into]) &&
          std::any_of(faces.begin(), faces.end(),
            [&](std::uint32_t f) { return m_.isWall(f) && faces_.hasCorner(f, into); })));
  }

  // Makes the edit if the objective falls; returns by how much, or 0.
  double tryOut(const Edit& edit)
  {
    if (edit.kind == Edit::Kind::Join)
    {
      around_.faces = { std::min(edit.one, edit.other), std::max(edit.one, edit.other) };
    }
    else
    {
      setFaces(faces_.facesOf(edit.one));
    }
    faces_.lookAround(around_);
    energy_.keep(around_, kept_);
    const double before = energy_.known(around_);
    const double volume = volumeAround();
    const bool isMesh = edit.kind == Edit::Kind::Join
      ? faces_.join(edit.one, edit.other, around_)
      : faces_.collapse(edit.one, edit.other, around_);
    after_.faces = faces_.remaining();
    energy_.measure(after_.faces);
    if (isMesh && keepsShapes() && keepsWall(edit))
    {
      faces_.lookAround(after_);
      const double most = (1 - LeastGain) * before;
      const double after = energy_.evaluate(after_, most) +
        CostOfVolume * std::abs(volumeAround() - volume) /
          m_.cells.volumeOfBox[around_.cells.front()];
      if (after < most && faces_.isSound())
      {
        return before - after;
      }
    }
    takeBack();
    return 0;
  }

  void takeBack()
  {
    faces_.putBack();
    energy_.putBack(around_, kept_);
  }

  // Whether faces have stars and areas, and those of the wall about the normals that they had.
  bool keepsShapes() const
  {
    return std::all_of(after_.faces.begin(), after_.faces.end(), [&](std::uint32_t f) {
      const auto at = std::lower_bound(around_.faces.begin(), around_.faces.end(), f);
      const auto i = static_cast<std::size_t>(at - around_.faces.begin());
      const double leastArea = LeastArea * task_.edges[f] * task_.edges[f];
      return energy_.star(f) >= std::min(LeastStar, kept_.stars[i]) &&
        norm(energy_.measures(f).area) >= std::min(leastArea, norm(kept_.faces[i].area)) &&
        (!m_.isWall(f) ||
          dot(unit(kept_.faces[i].area), unit(energy_.measures(f).area)) >= LeastTurnedCosine);
    });
  }

  bool keepsWall(const Edit& edit) const
  {
    for (std::size_t i = 0; i < around_.faces.size(); ++i)
    {
      const std::uint32_t f = edit.kind == Edit::Kind::Join ? edit.one : around_.faces[i];
      if (m_.isWall(f) && !faces_.isGone(f))
      {
        const FaceGeometry& face = energy_.measures(f);
        const double off = dot(minus(kept_.faces[i].centre, face.centre), unit(face.area));
        if (std::abs(off) > FarthestFromWall * task_.edges[f])
        {
          return false;
        }
      }
    }
    return true;
  }

  double volumeAround() const
  {
    double sum = 0;
    for (const std::uint32_t c : around_.cells)
    {
      sum += m_.cells.measures[c].volume;
    }
    return sum;
  }

  const MendingTask& task_;
  NodeMesh& m_;
  MeshEnergy& energy_;
  Execution& execution_;
  FaceEdits faces_;
  std::vector<double> edgeOf_;       // of the smallest box around each node
  std::vector<std::uint32_t> topOf_; // of the prism on a node, or None; empty: no prisms
  std::uint32_t now_ = 0;
  std::vector<std::uint32_t> changedAt_; // of cells
  std::vector<std::uint32_t> lookedAtFace_;
  std::vector<std::uint32_t> lookedAtNode_;
  std::vector<std::uint32_t> nodes_; // to be moved
  std::vector<Edit> edits_;
  Surroundings around_;
  Surroundings after_;
  MeshEnergy::Kept kept_;
};

}

std::vector<FaceEdit> mendWorstFaces(
  const MendingTask& task, MeshEnergy& energy, Execution& execution)
{
  return Mender(task, energy, execution).run();
}

}
