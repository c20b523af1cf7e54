#include "machine.hpp"

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace velum {

std::uint64_t physical_memory() {
#if defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && page_size > 0)
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_size);
#endif
  return 0;
}

}  // namespace velum
