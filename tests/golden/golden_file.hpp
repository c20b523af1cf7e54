#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <velum/velum.hpp>

/// Committed pictures: compared, and refreshed where they differ.
namespace golden {

/// Where things lie.
struct Places {
  std::filesystem::path pictures;  ///< the committed PNGs
  std::filesystem::path failures;  ///< where a failure leaves what a person wants to see; made when needed
};

/// The file of a picture: "ties/cabinet" → "ties.cabinet.png".
std::filesystem::path file_name(const std::string& name);

/// Compares a picture with its committed PNG. A file that is missing is a failure like any other. On failure
/// NAME.actual.png and, as far as there is something to compare with, NAME.expected.png and NAME.heat.png are
/// saved.
/// @return nothing where they are equal; otherwise a sentence for a person, with the paths
std::optional<std::string> failure_of(const std::string& name, const velum::Image<velum::Rgba8>& actual,
                                      const Places& places);

/// The same for two pictures at hand. @param expected_name how the sentence calls it
std::optional<std::string> failure_of(const std::string& name, const velum::Image<velum::Rgba8>& actual,
                                      const velum::Image<velum::Rgba8>& expected,
                                      const std::string& expected_name, const Places& places);

/// Writes the committed PNG if there is none or its pixels differ; a file that is as it should be is not
/// touched.
/// @return whether it was written
bool refresh(const std::string& name, const velum::Image<velum::Rgba8>& actual, const Places& places);

/// Writes a text file if its content differs. @return whether it was written
bool refresh_text(const std::filesystem::path& path, const std::string& text);

}  // namespace golden
