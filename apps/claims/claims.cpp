#include "claim.hpp"

namespace velum_claims {

const char* name_of(Verdict verdict) {
  constexpr const char* names[] = {"holds", "holds in part", "does not hold here"};
  return names[static_cast<int>(verdict)];
}

std::vector<Claim> test_claims(const std::vector<Subject>& subjects, const Effort& effort,
                               const std::function<void(const std::string&)>& tell) {
  const std::pair<const char*, std::function<Claim()>> tests[] = {
      {"growth with n", [&] { return claim_growth(effort); }},
      {"nodes and intersections per ray", [&] { return claim_structures(subjects, effort); }},
      {"bounding volumes", [&] { return claim_bounding_volumes(subjects, effort); }},
      {"resolution of a grid", [&] { return claim_grid_resolution(subjects, effort); }},
      {"the ball in the stadium", [&] { return claim_nested_grid(effort); }},
      {"share of intersections", [&] { return claim_share_of_intersection(subjects, effort); }},
      {"surface-area heuristic", [&] { return claim_surface_area_heuristic(subjects, effort); }},
      {"number of rays", [&] { return claim_number_of_rays(subjects, effort); }},
      {"back faces", [&] { return claim_back_faces(subjects, effort); }},
      {"kept kd-trees", [&] { return claim_tree_file(effort); }},
      {"moving scenes", [&] { return claim_moving_scenes(effort); }},
  };
  std::vector<Claim> claims;
  for (const auto& [name, test] : tests) {
    tell(name);
    claims.push_back(test());
  }
  return claims;
}

}  // namespace velum_claims
