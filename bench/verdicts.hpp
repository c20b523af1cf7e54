#pragma once

#include <string>
#include <vector>

#include "machine_limits.hpp"
#include "measure.hpp"
#include "plots.hpp"

namespace velum_bench {

/// One line of the check: a figure against what was wanted of it.
struct Verdict {
  enum class Kind { pass, fail, info };
  Kind kind = Kind::info;
  std::string what;
  std::string reached;
  std::string wanted;
  std::string hoped;
  std::string note;
};

/// What was measured for the check. A row that is not there is one that could not be measured.
struct CheckFigures {
  std::vector<Row> frames;      ///< of ratio_goals
  std::vector<Row> depth_only;  ///< of occlusion_goals
  std::vector<ThreadRow> threads;
  MachineLimits limits;
};

/// One verdict per goal (goals.hpp), then how near the frames come to the machine's limits. What could not be
/// measured fails.
std::vector<Verdict> verdicts_on(const CheckFigures& figures);

bool all_pass(const std::vector<Verdict>& verdicts);
Table table_of(const std::vector<Verdict>& verdicts);

}  // namespace velum_bench
