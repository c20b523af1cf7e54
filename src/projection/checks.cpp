#include "checks.hpp"

#include <charconv>
#include <cmath>

#include "../base/elementary.hpp"
#include "../base/error.hpp"
#include "camera_axes.hpp"

namespace velum {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& demand) {
  throw Error(ErrorKind::usage, name + " is " + value, name, "it must be " + demand);
}

double largest_in_row(const glm::dmat4& m, int row) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column) largest = glm::max(largest, std::abs(m[column][row]));
  return largest;
}

double largest_in_column(const glm::dvec4& column) {
  const glm::dvec4 a = glm::abs(column);
  return glm::max(glm::max(a.x, a.y), glm::max(a.z, a.w));
}

// The determinant after each column and then each row is scaled to largest entry 1: it then tells how close
// the matrix is to a singular one, whatever units its rows and columns are in.
double equilibrated_determinant(glm::dmat4 m) {
  for (int column = 0; column < 4; ++column) {
    const double largest = largest_in_column(m[column]);
    if (largest == 0.0) return 0.0;
    m[column] /= largest;
  }
  for (int row = 0; row < 4; ++row) {
    const double largest = largest_in_row(m, row);
    if (largest == 0.0) return 0.0;
    for (int column = 0; column < 4; ++column) m[column][row] /= largest;
  }
  return glm::determinant(m);
}

}  // namespace

std::string text_of(double value) {
  char buffer[32];
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

std::string text_of(const glm::dvec3& value) {
  return std::string("(") + text_of(value.x) + ", " + text_of(value.y) + ", " + text_of(value.z) + ")";
}

void check_finite(double value, const std::string& name) {
  if (!std::isfinite(value)) refuse(name, text_of(value), "a finite number");
}

void check_finite(const glm::dvec2& value, const std::string& name) {
  check_finite(value.x, name + ".x");
  check_finite(value.y, name + ".y");
}

void check_finite(const glm::dvec3& value, const std::string& name) {
  if (!is_finite(value)) refuse(name, text_of(value), "finite in every component");
}

void check_positive(double value, const std::string& name) {
  if (!(std::isfinite(value) && value > 0.0)) refuse(name, text_of(value), "finite and greater than 0");
}

void check_direction(const glm::dvec3& value, const std::string& name) {
  check_finite(value, name);
  if (value == glm::dvec3(0.0)) refuse(name, text_of(value), "a direction: not zero");
}

void check_opening_angle(double radians, const std::string& name) {
  if (!(radians > 0.0 && radians < pi)) {
    refuse(name, text_of(degrees(radians)) + " degrees", "greater than 0 and less than 180 degrees");
  }
}

bool is_regular(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return std::abs(equilibrated_determinant(matrix)) > 1e-15;
}

void check_regular(const glm::dmat4& matrix, const std::string& name) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      check_finite(matrix[column][row],
                   name + "[row " + std::to_string(row) + "][column " + std::to_string(column) + "]");
    }
  }
  if (is_regular(matrix)) return;
  throw Error(ErrorKind::usage, "the matrix is singular", name,
              "a view into a volume must keep depth; pictures on a plane are in plane_projection.hpp");
}

}  // namespace velum
