#include "page.hpp"

#include <set>
#include <velum/velum.hpp>

namespace velum_docs {
namespace {

constexpr const char* opening = "<!-- made: ";
constexpr const char* closing = "<!-- end -->\n";

[[noreturn]] void fail(const std::string& problem, const std::string& page) {
  throw velum::Error(velum::ErrorKind::read, problem, page,
                     "name a block that apps/docs/blocks.cpp makes, once, and close it with <!-- end -->");
}

}  // namespace

std::string filled_in(const std::string& page, const Blocks& blocks, const std::string& name) {
  std::string result;
  std::set<std::string> used;
  std::size_t at = 0;
  for (;;) {
    const std::size_t mark = page.find(opening, at);
    if (mark == std::string::npos) break;
    const std::size_t end_of_line = page.find('\n', mark);
    const std::size_t end = page.find(closing, mark);
    if (end_of_line == std::string::npos || end == std::string::npos) fail("a part is not closed", name);
    const std::string line = page.substr(mark, end_of_line - mark);
    const std::size_t begin = std::string(opening).size();
    const std::string block = line.substr(begin, line.find(" -->") - begin);
    const auto made = blocks.find(block);
    if (made == blocks.end()) fail("nothing is made for \"" + block + "\"", name);
    if (!used.insert(block).second) fail("\"" + block + "\" has two places", name);
    result += page.substr(at, end_of_line + 1 - at) + "\n" + made->second + "\n" + closing;
    at = end + std::string(closing).size();
  }
  for (const auto& [block, text] : blocks) {
    if (used.count(block) == 0) fail("\"" + block + "\" has no place", name);
  }
  return result + page.substr(at);
}

}  // namespace velum_docs
