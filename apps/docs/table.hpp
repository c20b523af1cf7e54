#pragma once

#include <string>
#include <vector>

namespace velum_docs {

/// A table of text cells: as Markdown, or aligned for a block of plain text.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}

  /// @pre as many cells as the header has
  void add(std::vector<std::string> row);

  /// Pipes and a rule under the header; the first column to the left, the others to the right.
  std::string markdown() const;
  /// Columns aligned to the right with two spaces between them, in a block of plain text.
  std::string text() const;

 private:
  std::vector<std::size_t> widths() const;

  std::vector<std::vector<std::string>> rows_;
};

/// A fenced block of plain text.
std::string fenced(const std::string& text);

}  // namespace velum_docs
