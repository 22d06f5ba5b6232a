// Random assemblies as CAD systems write them: bodies that touch in a plane, stand flush or share corners, with corners
// nearly in one place, turned, in decimals or single precision, as one region or several. All become one, or walls
// between regions, and their volume is that of the union.
#include "Base/Error.h"
#include "Support/ConvexBodies.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace cartesian;

namespace
{

Soup inDecimals(const Soup& soup, int digits)
{
  const double whole = std::pow(10, digits);
  return soup.each([&](const Vector& p) {
    return Vector{ std::round(p[0] * whole) / whole, std::round(p[1] * whole) / whole,
      std::round(p[2] * whole) / whole };
  });
}

Soup inSinglePrecision(const Soup& soup)
{
  return soup.each([](const Vector& p) {
    return Vector{ double(float(p[0])), double(float(p[1])), double(float(p[2])) };
  });
}

class Assembly
{
public:
  explicit Assembly(unsigned seed)
    : random_(seed)
  {
    random_.discard(10);
    near_ = std::pow(10, between(-7, -2));
    switch (whole(0, 4))
    {
      case 0:
        bodies_ = { standing(1), standing(-1) };
        break;
      case 1:
        bodies_ = { standing(1), standing(1) };
        break;
      case 2:
        addStanding(whole(2, 6));
        break;
      case 3:
        addBoxes(whole(2, 6));
        break;
      default:
        addFan(whole(3, 6));
        break;
    }
    place();
  }

  const std::vector<Soup>& bodies() const { return bodies_; }
  double exactVolume() const { return volume_; }
  bool isSingle() const { return isSingle_; }
  bool isOfRegions() const { return isOfRegions_; }

  Soup soup() const
  {
    Soup soup;
    for (const Soup& body : bodies_)
    {
      if (isOfRegions_)
      {
        soup.addRegion(body);
      }
      else
      {
        soup.add(body);
      }
    }
    return soup;
  }

private:
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  // A tetrahedron with a face in z = 0, on one side of it; corners of that are near to others there.
  Soup standing(int side)
  {
    std::array<Vector, 4> c{};
    do
    {
      for (Vector& p : c)
      {
        p = { between(-1, 1), between(-1, 1), 0 };
      }
      for (int i = 0; i < 3 && !inPlane_.empty(); ++i)
      {
        if (whole(0, 2) == 0)
        {
          c[i] = aside(inPlane_[static_cast<std::size_t>(whole(0, int(inPlane_.size()) - 1))]);
        }
      }
      c[3][2] = side * between(0.1, 0.6);
    } while (std::abs(cross(minus(c[1], c[0]), minus(c[2], c[0]))[2]) < 0.1);
    inPlane_.insert(inPlane_.end(), c.begin(), c.begin() + 3);
    return outward(c);
  }

  Vector aside(const Vector& p)
  {
    return { p[0] + between(-near_, near_), p[1] + between(-near_, near_), p[2] };
  }

  static Soup outward(const std::array<Vector, 4>& corners)
  {
    const Soup soup = tetrahedron(corners);
    return soup.volume() < 0 ? soup.flipped() : soup;
  }

  void addStanding(int count)
  {
    for (int n = 0; n < count; ++n)
    {
      bodies_.push_back(standing(whole(0, 1) == 0 ? 1 : -1));
    }
  }

  // Between common planes; in none of them lies another.
  void addBoxes(int count)
  {
    areBoxes_ = true;
    std::array<std::vector<double>, 3> planes;
    for (std::vector<double>& of : planes)
    {
      for (int i = 0; i < 4; ++i)
      {
        of.push_back(0.5 * i - 1 + std::round(between(0, 0.4) * 1e5) / 1e5);
      }
    }
    for (int tries = 0; tries < 200 && int(bodies_.size()) < count; ++tries)
    {
      Vector low;
      Vector high;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const int first = whole(0, 2);
        low[axis] = planes[axis][static_cast<std::size_t>(first)];
        high[axis] = planes[axis][static_cast<std::size_t>(whole(first + 1, 3))];
      }
      Soup one = box(low, high);
      one.boundary.clear();
      if (std::none_of(bodies_.begin(), bodies_.end(),
            [&](const Soup& other) { return contains(one, other) || contains(other, one); }))
      {
        bodies_.push_back(one);
      }
    }
  }

  // As seen along each axis, so that none lies between two others that share a face: it would be a void there.
  static bool contains(const Soup& outer, const Soup& inner)
  {
    int axes = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      axes +=
        outer.low()[axis] <= inner.low()[axis] && outer.high()[axis] >= inner.high()[axis] ? 1 : 0;
    }
    return axes > 1;
  }

  // Tetrahedra around a line, whose corners at one end of it are nearly in one place, on the base of another.
  void addFan(int count)
  {
    bodies_ = { standing(1) };
    const Vector apex{ between(-0.3, 0.3), between(-0.3, 0.3), -between(0.2, 0.6) };
    const Vector centre{ between(-0.3, 0.3), between(-0.3, 0.3), 0 };
    std::vector<Vector> ring;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2 * M_PI * (i + between(0, 0.5)) / count;
      const double radius = between(0.4, 1);
      ring.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      bodies_.push_back(outward({ aside(centre), ring[i], ring[(i + 1) % ring.size()], apex }));
    }
  }

  // As it is, turned so that few decimals stay few, or anyhow; in some size, and as files round it.
  void place()
  {
    const int way = whole(0, 2);
    const double angle = between(0, 360);
    const Vector by{ between(-1, 1), between(-1, 1), between(-1, 1) };
    const int digits = whole(3, 9);
    const double size = std::pow(10, whole(-1, 2));
    isSingle_ = whole(0, 2) == 0;
    isOfRegions_ = whole(0, 3) == 0;
    const std::vector<Soup> given = bodies_;
    const double toFifths = std::asin(0.8) * 180 / M_PI;
    for (Soup& body : bodies_)
    {
      body = way == 0
        ? body
        : (way == 1 ? body.turned(2, toFifths) : body.turned(2, angle).turned(0, 30).moved(by));
      // The faces of a box are flat, whatever its corners are rounded to.
      body = areBoxes_ ? body : inDecimals(body, digits);
      body = body.scaled(size);
      body = isSingle_ ? inSinglePrecision(body) : body;
    }
    volume_ = areBoxes_ ? volumeOfUnion(given) * std::pow(size, 3) : volumeOfUnion(bodies_);
  }

  std::mt19937 random_;
  double near_ = 0;
  std::vector<Vector> inPlane_; // corners
  bool areBoxes_ = false;
  bool isSingle_ = false;
  bool isOfRegions_ = false;
  std::vector<Soup> bodies_;
  double volume_ = 0;
};

// How far off the file's precision puts the volume at most.
double boundOf(const Assembly& assembly)
{
  const Soup soup = assembly.soup();
  double largest = 0;
  for (const Vector& p : soup.points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  const double rounding = assembly.isSingle() ? largest * std::pow(2, -24) : 0;
  return 1e-7 * assembly.exactVolume() + 4 * rounding * soup.area();
}

// Whether its bodies became one, or its regions one surface of walls.
bool isArranged(const Assembly& assembly)
{
  const Soup soup = assembly.soup();
  try
  {
    const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 5));
    if (!prepared.repair.refused.empty())
    {
      return false;
    }
    EXPECT_NEAR(volumeOf(prepared.surface), assembly.exactVolume(), boundOf(assembly));
    return true;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::FlawedSurface);
    EXPECT_TRUE(assembly.isOfRegions());
    return std::string(error.what()).find("intersects others") == std::string::npos;
  }
}

// Two tetrahedra on either side of a plane, two of whose corners are 4e-5 apart.
Soup nearCorners()
{
  Soup soup = tetrahedron({ Vector{ 0.0766524, 0.8413099, 0 }, Vector{ 0.0152397, -0.1574662, 0 },
    Vector{ 0.3162846, -0.069862, 0 }, Vector{ -0.8098497, -0.2421195, -0.3950971 } });
  soup = soup.volume() < 0 ? soup.flipped() : soup;
  const Soup above =
    tetrahedron({ Vector{ 0.0766584, 0.8413478, 0 }, Vector{ -0.121379, -0.8584462, 0 },
      Vector{ -0.773944, -0.4751688, 0.3756258 }, Vector{ 0.0485714, -0.7876475, 0.1974652 } });
  return soup.addRegion(above.volume() < 0 ? above.flipped() : above);
}

TEST(RandomAssemblies, CornersThatNearlyTouch)
{
  for (const double size : { 1.0, 0.01, 300.0 })
  {
    for (int way = 0; way < 4; ++way)
    {
      for (const bool isOne : { true, false })
      {
        SCOPED_TRACE(testing::Message() << size << " way " << way << " one region " << isOne);
        Soup soup = nearCorners();
        soup = way == 0
          ? soup
          : (way == 1 ? soup.turned(2, 17)
                      : (way == 2 ? soup.turned(0, 30).turned(1, 45) : soup.turned()));
        soup = soup.scaled(size);
        if (isOne)
        {
          soup.region.clear();
        }
        const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 30));
        EXPECT_TRUE(prepared.repair.refused.empty());
        EXPECT_NEAR(
          volumeOf(prepared.surface), 0.075656172 * std::pow(size, 3), 1e-8 * std::pow(size, 3));
      }
    }
  }
}

// At most one of 500 is refused; 19 were, when there was only one way to arrange them.
TEST(RandomAssemblies, AreUnited)
{
  int refused = 0;
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    SCOPED_TRACE(seed);
    refused += isArranged(Assembly(seed)) ? 0 : 1;
  }
  EXPECT_LE(refused, 1);
}

}
