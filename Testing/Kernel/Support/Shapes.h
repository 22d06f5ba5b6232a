// Named shapes as triangle soups, for the tests.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

#include <functional>
#include <ostream>
#include <random>
#include <string>

namespace cartesian
{

// Triangles with outward normals.
struct Soup
{
  std::vector<Vector> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> boundary; // of each triangle, or empty: all 0
  std::vector<std::int32_t> region;   // of each triangle, or empty: there is only one
  std::vector<std::array<std::uint32_t, 2>> sharpEdges; // points
  std::vector<std::uint8_t> knowsEdges;                 // of each triangle, or empty: all 0

  SurfaceView view() const; // borrows

  std::int32_t boundaryOf(std::size_t triangle) const
  {
    return boundary.empty() ? 0 : boundary[triangle];
  }
  double volume() const;
  double area(std::size_t triangle) const;
  double area() const;
  double edgeLength() const; // each edge of two triangles counted once
  Vector low() const;
  Vector high() const;
  double longest() const;

  Soup& add(const Soup& other);
  Soup& addRegion(const Soup& other); // the first, or after those that are there
  Soup each(const std::function<Vector(const Vector&)>& move) const;
  Soup moved(const Vector& by) const;
  Soup scaled(double by) const;
  Soup scaled(const Vector& by) const;
  Soup turned(int axis, double degrees) const;
  Soup turned() const;                                 // by arbitrary angles about all axes
  Soup permuted(const std::array<int, 3>& axes) const; // new axis a is the old axes[a]
  Soup flipped() const;                                // with opposite normals
};

Soup box(const Vector& low, const Vector& high); // boundaries 0 to 5: low x, high x, low y, ...
Soup cube();                                     // 0 to 1
Soup octahedron(double radius);                  // vertices on the axes
Soup tetrahedron(const std::array<Vector, 4>& corners);
Soup sphere(int n, double radius); // 12 n^2 triangles
Soup torus(int n, double radius, double tube);
Soup needle();          // 1 long, 1e-4 thick
Soup pyramidOnAPlane(); // its apex touches the inside of a slab's face
Soup nestedSpheres();   // a ball with a ball cut out
Soup comb(int teeth);   // thin sheets on a base
Soup blockWithTubes();  // 3 x 3
Soup beadOnAThread(
  double thickness); // of the thread, from a block of 4 to a bead of 0.8, at x from 7
// Along z, of radius 1: its ends, 1 and 2, are polygons of so many corners, its walls, 0, thin triangles.
Soup tubeWithEnds(std::uint32_t lower, std::uint32_t upper, double length);
Soup kleinBottle(int n); // a figure of eight swept around with half a twist: intersects itself
Soup starPolyhedron(unsigned seed, int n);
Soup bumpySphere(unsigned seed, int n);

// The boxes of the grid for which `inside` is true, as one closed surface.
Soup voxels(const std::array<std::vector<double>, 3>& lines,
  const std::function<bool(int i, int j, int k)>& inside);

// Tetrahedra with random corners at odd coordinates from 1 to 2 * width + 1. Each is closed, but
// they overlap, touch and share corners; some have no volume.
Soup randomTetrahedra(unsigned seed, int count, int width);

struct NamedShape
{
  std::string name;
  Soup soup;
};
std::ostream& operator<<(std::ostream& stream, const NamedShape& shape); // its name, for GoogleTest

// Closed, consistently oriented surfaces that do not intersect themselves.
const std::vector<NamedShape>& cleanShapes();

// Likewise, but with walls or gaps of a few lattice steps, which a coarser lattice would lose.
std::vector<NamedShape> thinShapes();

}
