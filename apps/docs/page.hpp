#pragma once

#include <map>
#include <string>

namespace velum_docs {

/// The made parts of a page by name: Markdown, ending with a line break.
using Blocks = std::map<std::string, std::string>;

/// Replaces what stands between the lines `<!-- made: NAME -->` and `<!-- end -->` by the block of that name.
/// Everything else stays as it is.
/// @param name  of the page, for messages
/// @throws velum::Error (read) for a name that is not made, a part without end, and a block without a place
std::string filled_in(const std::string& page, const Blocks& blocks, const std::string& name);

}  // namespace velum_docs
