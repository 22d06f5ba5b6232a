#include "Support/ConvexBodies.h"

#include <algorithm>

namespace cartesian
{

namespace
{

using Polygon = std::vector<Vector>;

struct Plane
{
  Vector at;
  Vector normal; // outward
};

Plane planeOf(const Soup& body, std::size_t triangle)
{
  const auto& t = body.triangles[triangle];
  const Vector& p = body.points[t[0]];
  return { p, cross(minus(body.points[t[1]], p), minus(body.points[t[2]], p)) };
}

// The faces of a convex body behind a plane.
std::vector<Polygon> clipped(const std::vector<Polygon>& faces, const Plane& plane)
{
  const double touching = 1e-12 * norm(plane.normal);
  std::vector<Polygon> result;
  Polygon cap;
  for (const Polygon& face : faces)
  {
    Polygon kept;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Vector& p = face[i];
      const Vector& q = face[(i + 1) % face.size()];
      const double from = dot(minus(p, plane.at), plane.normal);
      const double to = dot(minus(q, plane.at), plane.normal);
      if (from <= touching)
      {
        kept.push_back(p);
      }
      if ((from > touching) != (to > touching))
      {
        kept.push_back(plus(p, scaled(minus(q, p), from / (from - to))));
        cap.push_back(kept.back());
      }
    }
    if (kept.size() > 2)
    {
      result.push_back(kept);
    }
  }
  if (cap.size() > 2)
  {
    // Convex: in order of the angle around its middle.
    Vector middle{};
    for (const Vector& p : cap)
    {
      middle = plus(middle, scaled(p, 1. / static_cast<double>(cap.size())));
    }
    const Vector x = unit(minus(cap[0], middle));
    const Vector y = cross(unit(plane.normal), x);
    const auto angle = [&](const Vector& p) {
      return std::atan2(dot(minus(p, middle), y), dot(minus(p, middle), x));
    };
    std::sort(cap.begin(), cap.end(),
      [&](const Vector& a, const Vector& b) { return angle(a) < angle(b); });
    result.push_back(cap);
  }
  return result;
}

std::vector<Polygon> facesOf(const Soup& body)
{
  std::vector<Polygon> faces;
  for (const auto& t : body.triangles)
  {
    faces.push_back({ body.points[t[0]], body.points[t[1]], body.points[t[2]] });
  }
  return faces;
}

double volumeOf(const std::vector<Polygon>& faces)
{
  double volume = 0;
  for (const Polygon& face : faces)
  {
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
    {
      volume += dot(minus(face[0], faces[0][0]),
                  cross(minus(face[i], faces[0][0]), minus(face[i + 1], faces[0][0]))) /
        6;
    }
  }
  return volume;
}

// What bodies from `next` on add to and take from the union, all within these faces.
double sumOf(
  const std::vector<Soup>& bodies, std::size_t next, const std::vector<Polygon>& within, int sign)
{
  double sum = 0;
  for (std::size_t n = next; n < bodies.size(); ++n)
  {
    std::vector<Polygon> faces = within.empty() ? facesOf(bodies[n]) : within;
    for (std::size_t t = 0; !within.empty() && t < bodies[n].triangles.size() && !faces.empty();
         ++t)
    {
      faces = clipped(faces, planeOf(bodies[n], t));
    }
    if (!faces.empty())
    {
      sum += sign * volumeOf(faces) + sumOf(bodies, n + 1, faces, -sign);
    }
  }
  return sum;
}

}

double volumeOfUnion(const std::vector<Soup>& bodies)
{
  return sumOf(bodies, 0, {}, 1);
}

}
