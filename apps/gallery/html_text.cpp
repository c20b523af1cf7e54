#include "html_text.hpp"

#include <array>
#include <charconv>

namespace velum_gallery {

std::string number_text(double value, int digits) {
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0.0 ? 0.0 : value,
                                 std::chars_format::general, digits)
                       .ptr;
  return std::string(buffer.data(), end);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string stage_html(const velum::Stage& stage) {
  std::string html = "<li><b>" + escaped(std::string(stage.name)) + "</b> " +
                     escaped(std::string(stage.meaning)) + "<table>";
  for (int row = 0; row < 4; ++row) {
    html += "<tr>";
    for (int column = 0; column < 4; ++column) {
      html += "<td>" + number_text(stage.matrix[column][row], 5) + "</td>";
    }
    html += "</tr>";
  }
  return html + "</table></li>\n";
}

}  // namespace velum_gallery
