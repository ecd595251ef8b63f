#include "job/internal/edit_contours.hpp"

#include <cmath>
#include <string>

namespace kerf::job {
namespace {

using contour::Contour;
using contour::Vec2;
using contour::Vertex;

constexpr std::size_t kMostPoints = 1'000'000;
constexpr double kLargestBulge = 1e4;  // all of a circle but a hundredth of a degree

double bulge_at(const EditReading& reading, std::size_t value) {
  const double bulge = number_at(reading.json, value, "A BULGE");
  if (std::fabs(bulge) > kLargestBulge) {
    throw Misread{"A BULGE IS BEYOND 10000: A WHOLE CIRCLE IS TWO ARCS", value};
  }
  return bulge;
}

Vertex vertex_at(EditReading& reading, std::size_t value) {
  const auto parts = elements_at(reading.json, value, "A POINT OF A CONTOUR");
  if (parts.size() != 2 && parts.size() != 3) {
    throw Misread{reading.turns ? "A POINT OF A CONTOUR IS [z, x] OR [z, x, bulge]"
                                : "A POINT OF A CONTOUR IS [x, y] OR [x, y, bulge]",
                  value};
  }
  if (++reading.points > kMostPoints) {
    throw Misread{"MORE THAN " + std::to_string(kMostPoints) + " POINTS OF CONTOURS", value};
  }
  Vertex vertex{{number_at(reading.json, parts[0], "A COORDINATE"),
                 number_at(reading.json, parts[1], "A COORDINATE")}};
  if (parts.size() == 3) vertex.bulge = bulge_at(reading, parts[2]);
  return vertex;
}

}  // namespace

Vec2 point_at(EditReading& reading, std::size_t value, const std::string& what) {
  const auto parts = elements_at(reading.json, value, what);
  if (parts.size() != 2) throw Misread{what + " IS NO PAIR OF COORDINATES", value};
  return {number_at(reading.json, parts[0], "A COORDINATE"),
          number_at(reading.json, parts[1], "A COORDINATE")};
}

Contour contour_at(EditReading& reading, std::size_t value, bool is_closed) {
  Contour contour{{}, is_closed};
  for (const std::size_t point : elements_at(reading.json, value, "A CONTOUR")) {
    contour.vertices.push_back(vertex_at(reading, point));
  }
  if (contour.vertices.size() < 2) throw Misread{"A CONTOUR HAS TWO POINTS OR MORE", value};
  return contour;
}

std::vector<Contour> contours_at(EditReading& reading, std::size_t value) {
  std::vector<Contour> contours;
  for (const std::size_t one : elements_at(reading.json, value, "`islands`")) {
    contours.push_back(contour_at(reading, one, true));
  }
  return contours;
}

}  // namespace kerf::job
