#include "RandomTask.h"

#include "Support/FuzzedSurface.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr std::size_t BytesOfASurface = 96;
constexpr double Never = std::numeric_limits<double>::quiet_NaN();

class Draw
{
public:
  explicit Draw(unsigned seed)
    : random_(seed)
  {
  }

  // Not std::uniform_real_distribution: its numbers depend on the library.
  double uniform(double low, double high)
  {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  int from(int low, int high) { return low + below(high - low + 1); }
  bool once(int in) { return below(in) == 0; }

  // One of some values at which something changes, or any from the first to the last of them.
  double of(const std::vector<double>& values)
  {
    return once(2) ? values[static_cast<std::size_t>(below(static_cast<int>(values.size())))]
                   : uniform(values.front(), values.back());
  }

  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }

private:
  std::mt19937 random_;
};

Soup surface(Draw& draw)
{
  if (draw.once(4))
  {
    const auto& shapes = cleanShapes();
    return shapes[static_cast<std::size_t>(draw.below(static_cast<int>(shapes.size())))].soup;
  }
  if (draw.once(3))
  {
    return starPolyhedron(static_cast<unsigned>(draw.below(1000)), draw.from(1, 4))
      .scaled({ 1, draw.of({ 0.01, 1 }), draw.of({ 0.1, 1 }) });
  }
  std::vector<std::uint8_t> bytes(BytesOfASurface);
  std::generate(bytes.begin(), bytes.end(), [&] { return draw.byte(); });
  return editedShapes(bytes.data(), bytes.size());
}

// Boundaries of many triangles each, and speckles.
void drawBoundaries(Soup& soup, Draw& draw)
{
  const int count = draw.from(1, 4);
  soup.boundary.clear();
  for (const auto& triangle : soup.triangles)
  {
    const Vector& p = soup.points[triangle[0]];
    const int number = (p[0] > 0.1) + 2 * (p[1] > 0.1);
    soup.boundary.push_back(draw.once(20) ? draw.below(count) : number % count);
  }
}

GridSpec grid(const Soup& soup, Draw& draw)
{
  GridSpec grid = cellsAlongLongest(soup, draw.of({ 0.5, 1, 3, 5, 7, 10 }));
  const Vector low = soup.low();
  const Vector high = soup.high();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (draw.once(4))
    {
      const double size = high[axis] - low[axis];
      std::vector<double>& lines = grid.meshlines[axis];
      for (int i = draw.from(2, 8); i > 0; --i)
      {
        lines.push_back(low[axis] + size * draw.of({ -0.5, 0, 0.25, 0.5, 1, 1.5 }));
      }
      std::sort(lines.begin(), lines.end());
      lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    }
  }
  return grid;
}

RefinementSpec refinement(RandomTask& task, Draw& draw)
{
  constexpr int Deepest = 3;
  RefinementSpec spec;
  spec.depth = draw.once(2) ? 0 : draw.from(0, 2);
  for (int n = draw.once(3) ? draw.from(1, 2) : 0; n > 0; --n)
  {
    RefinementBlock block{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.first[axis] = draw.from(-1, 6);
      block.last[axis] = block.first[axis] + draw.from(0, 3);
    }
    block.allowed = draw.from(0, Deepest);
    block.forced = draw.from(0, std::min(2, block.allowed));
    spec.blocks.push_back(block);
  }
  const auto& boundaries = task.soup.boundary;
  for (int n = draw.once(3) && !boundaries.empty() ? draw.from(1, 2) : 0; n > 0; --n)
  {
    const auto any = static_cast<std::size_t>(draw.below(static_cast<int>(boundaries.size())));
    spec.boundaries.push_back(
      { boundaries[any], draw.from(0, Deepest), draw.from(0, 2), draw.once(2) });
  }
  if (draw.once(4))
  {
    const double size = task.soup.longest();
    const Vector at = task.soup.low();
    task.regions.push_back(
      octahedron(size * draw.uniform(0.01, 0.6))
        .turned()
        .moved({ at[0] + draw.uniform(0, 1) * size, at[1] + draw.uniform(0, 1) * size, at[2] }));
    spec.regions.push_back({ task.regions.back().view(), draw.from(0, Deepest) });
  }
  return spec;
}

void drawCells(TestOptions& options, Draw& draw)
{
  options.patches.method = static_cast<PatchMethod>(draw.below(3));
  options.patches.featureAngle = draw.of({ 0, 30, 89, 90, 180 });
  options.patches.mergeAngle = draw.of({ 0, 10, 90 });
  options.patches.tying = static_cast<Tying>(draw.below(2));
  options.collapse.ratio = draw.of({ 0, 1e-9, 0.1, 0.3 });
  options.smallCells.ratio = draw.of({ 0, 1e-9, 1e-3, 0.2, 0.999 });
  options.smallCells.handling = static_cast<SmallCells>(draw.below(2));
  if (draw.once(4))
  {
    options.smallCells.boundaryRatios = { { 0, draw.of({ 0, 1e-100, 0.5 }) } };
  }
  options.shaping.mergeRatio = draw.of({ 0, 1e-6, 0.15, 0.999 });
  options.shaping.optimiseNodes = draw.once(2);
  options.shaping.splitConcave = draw.once(2);
  options.shaping.refusedCellRatio = draw.of({ 0, 1, 4, 100 });
  options.shaping.trueVolume = draw.once(2);
}

// The surface in a box whose sides may cut it off.
DomainSpec outside(const Soup& soup, Draw& draw)
{
  DomainSpec spec;
  spec.domain = Domain::Outside;
  spec.boxFrom = static_cast<BoxSource>(draw.below(2));
  spec.flow = static_cast<FlowDirection>(draw.below(6));
  for (double* lengths : { &spec.before, &spec.behind, &spec.beside })
  {
    *lengths = draw.of({ 0, 0.1, 0.5 });
  }
  spec.ground = static_cast<DomainSide>(draw.below(7));
  spec.half = static_cast<Half>(draw.below(4));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double size = soup.longest();
    spec.bounds.low[axis] = soup.low()[axis] + size * draw.of({ -0.5, 0, 0.3 });
    spec.bounds.high[axis] = soup.high()[axis] + size * draw.of({ -0.3, 0, 0.5 });
    spec.sides[2 * axis] = 1000;
    spec.sides[2 * axis + 1] = 1001;
  }
  return spec;
}

void drawLayers(RandomTask& task, Draw& draw)
{
  WallLayerSpec& layers = task.options.layers;
  const double size = task.soup.longest();
  layers.count = draw.from(1, 6);
  layers.ratio = draw.of({ 1, 1.2, 3 });
  layers.firstThickness = draw.once(2) ? 0 : size * draw.of({ 1e-6, 0.001, 0.02, 1 });
  layers.thickness = draw.once(2) ? 0 : size * draw.of({ 1e-6, 0.01, 0.1, 1 });
  for (int boundary = 0; boundary < 4; ++boundary)
  {
    if (draw.once(4))
    {
      layers.boundaries.push_back({ boundary, draw.once(2) ? 0 : size * draw.of({ 0.001, 0.1 }) });
    }
  }
}

// All lengths.
void scale(RandomTask& task, double by)
{
  task.soup = task.soup.scaled(by);
  GridSpec& grid = task.options.grid;
  grid.cellSize *= by;
  WallLayerSpec& layers = task.options.layers;
  layers.firstThickness *= by;
  layers.thickness *= by;
  for (WallLayerSpec::OfBoundary& one : layers.boundaries)
  {
    one.thickness *= by;
  }
  Bounds& box = task.options.domain.bounds;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.low[axis] *= by;
    box.high[axis] *= by;
  }
  for (auto& lines : grid.meshlines)
  {
    for (double& line : lines)
    {
      line *= by;
    }
  }
  for (std::size_t i = 0; i < task.regions.size(); ++i)
  {
    task.regions[i] = task.regions[i].scaled(by);
    task.options.refinement.regions[i].surface = task.regions[i].view();
  }
}

// One property out of its range.
void spoil(RandomTask& task, Draw& draw)
{
  TestOptions& o = task.options;
  const double bad = draw.once(2) ? Never : -draw.uniform(1e-9, 1e9);
  const std::vector<double*> numbers = { &o.grid.cellSize, &o.patches.featureAngle,
    &o.patches.mergeAngle, &o.collapse.ratio, &o.smallCells.ratio, &o.shaping.mergeRatio,
    &o.shaping.refusedCellRatio };
  *numbers[static_cast<std::size_t>(draw.below(static_cast<int>(numbers.size())))] = bad;
  task.valid = false;
}

}

RandomTask::RandomTask(unsigned seed)
{
  Draw draw(seed);
  soup = surface(draw);
  drawBoundaries(soup, draw);
  options.grid = grid(soup, draw);
  if (!draw.once(8)) // else all as a user finds it
  {
    options.refinement = refinement(*this, draw);
    drawCells(options, draw);
  }
  if (draw.once(4))
  {
    options.domain = outside(soup, draw);
  }
  if (draw.once(4))
  {
    drawLayers(*this, draw);
  }
  if (draw.once(10))
  {
    scale(*this, std::pow(10, draw.from(-160, 160)));
  }
  options.threads = draw.from(1, 3);
  if (draw.once(40))
  {
    spoil(*this, draw);
  }
}

std::string describe(const RandomTask& task)
{
  const TestOptions& o = task.options;
  std::ostringstream text;
  text << task.soup.triangles.size() << " triangles, cells " << o.grid.cellSize;
  for (const auto& lines : o.grid.meshlines)
  {
    text << (lines.empty() ? "" : ", meshlines");
    for (const double line : lines)
    {
      text << " " << line;
    }
  }
  text << ", layers " << o.layers.count << " " << o.layers.ratio << " " << o.layers.firstThickness
       << " " << o.layers.thickness << (o.layers.boundaries.empty() ? "" : " by boundary")
       << (o.domain.isOutside() ? ", outside" : "") << ", depth " << o.refinement.depth
       << ", blocks " << o.refinement.blocks.size();
  for (const BoundaryRefinement& row : o.refinement.boundaries)
  {
    text << ", boundary " << row.boundary << " " << row.depth << " " << row.blendLayers << " "
         << row.blendBelow;
  }
  text << ", regions " << o.refinement.regions.size() << ", method " << int(o.patches.method)
       << ", feature " << o.patches.featureAngle << ", merge angle " << o.patches.mergeAngle
       << ", true volume " << o.shaping.trueVolume << ", tying " << int(o.patches.tying)
       << ", collapse " << o.collapse.ratio << ", small " << o.smallCells.ratio
       << (o.smallCells.handling == SmallCells::Merge ? " merged" : " removed") << ", own ratios "
       << o.smallCells.boundaryRatios.size() << ", merge " << o.shaping.mergeRatio << ", optimise "
       << o.shaping.optimiseNodes << ", split " << o.shaping.splitConcave << ", refused "
       << o.shaping.refusedCellRatio << ", threads " << o.threads;
  return text.str();
}

}
