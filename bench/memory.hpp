#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace velum_bench {

/// The resident memory of this process and the most it was since reset_peak_memory(), bytes; none where the
/// system does not tell (/proc/self/status).
std::optional<std::uint64_t> resident_memory();
std::optional<std::uint64_t> peak_memory();

/// Gives freed memory back to the system and starts the peak again. @return whether the system can do that
bool reset_peak_memory();

/// Runs this program again with other arguments and gives the number it prints, so that nothing that this
/// process did counts; none if it prints none.
std::optional<std::uint64_t> number_from_child(const std::vector<std::string>& arguments);

}  // namespace velum_bench
