#include "matrix_text.hpp"

#include <algorithm>
#include <cmath>

#include "text.hpp"

namespace velum_app {
namespace {

/// Six places after the point, unless the number is too large or too small for that to say anything.
std::string element_text(double value) {
  const double size = std::abs(value);
  const bool plain = size == 0.0 || (size >= 1e-4 && size < 1e7);
  return plain ? fixed_text(value, 6) : number_text(value, 7);
}

std::string exact_element_text(double value) {
  return number_text(value, 9);
}

std::string rows_text(const glm::dmat4& matrix, std::string (*text_of)(double), std::size_t indent) {
  std::size_t width[4] = {};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      width[column] = std::max(width[column], text_of(matrix[column][row]).size());
    }
  }
  std::string text;
  for (int row = 0; row < 4; ++row) {
    text += std::string(indent, ' ') + "[ ";
    for (int column = 0; column < 4; ++column) {
      text += padded_left(text_of(matrix[column][row]), width[column]) + (column < 3 ? "   " : " ]\n");
    }
  }
  return text;
}

}  // namespace

std::string matrix_text(const glm::dmat4& matrix) {
  return rows_text(matrix, element_text, 4);
}

std::string long_matrix_text(const glm::dmat4& matrix) {
  return rows_text(matrix, exact_element_text, 7);
}

std::string vector_text(const glm::dvec4& vector) {
  return "(" + element_text(vector.x) + ", " + element_text(vector.y) + ", " + element_text(vector.z) + ", " +
         element_text(vector.w) + ")";
}

}  // namespace velum_app
