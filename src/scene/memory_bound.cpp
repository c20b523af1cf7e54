#include "memory_bound.hpp"

#include "../base/error.hpp"

namespace velum {

void require_within_memory_bound(std::size_t needed_bytes, std::size_t file_bytes, const std::string& what,
                                 const std::string& where) {
  // The rest of 64 times the size + 1 MiB is left to what the file is read into.
  constexpr std::size_t share = 40, allowance = 512 * 1024;
  if (needed_bytes / share <= file_bytes || needed_bytes <= allowance) return;
  throw Error(ErrorKind::read,
              what + " would take " + std::to_string(needed_bytes) + " bytes of memory, more than " +
                  std::to_string(share) + " times the size of the file",
              where, "check that the file is whole, or export it again");
}

}  // namespace velum
