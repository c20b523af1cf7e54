#pragma once

#include <functional>
#include <plots/table.hpp>
#include <string>
#include <vector>

#include "subjects.hpp"

namespace velum_claims {

enum class Verdict { holds, in_part, does_not_hold };
const char* name_of(Verdict verdict);

/// A sentence of a lecture, what was measured, and whether it is so here.
struct Claim {
  std::string title;
  std::string source;                ///< which lecture, and what it says
  std::string formula;               ///< one line
  std::string method;                ///< what was measured, and how
  std::vector<std::string> figures;  ///< SVG
  std::vector<velum_plots::Table> tables;
  Verdict verdict = Verdict::does_not_hold;
  std::string reason;  ///< of the verdict, with the figures that decide
};

/// How much is measured.
struct Effort {
  bool is_quick = false;  ///< a few seconds: small scenes and few rays
};

// One file each.
Claim claim_growth(const Effort& effort);
Claim claim_structures(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_bounding_volumes(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_nested_grid(const Effort& effort);
Claim claim_grid_resolution(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_share_of_intersection(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_surface_area_heuristic(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_number_of_rays(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_back_faces(const std::vector<Subject>& subjects, const Effort& effort);
Claim claim_tree_file(const Effort& effort);
Claim claim_moving_scenes(const Effort& effort);

/// All of them, in the order of the page. @param tell  called with each title before it is measured
std::vector<Claim> test_claims(const std::vector<Subject>& subjects, const Effort& effort,
                               const std::function<void(const std::string&)>& tell);

/// One HTML file that needs nothing beside it.
std::string page_of(const std::vector<Claim>& claims, const std::vector<Subject>& subjects);

}  // namespace velum_claims
