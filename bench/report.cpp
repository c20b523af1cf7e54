#include "report.hpp"

#include <sstream>

namespace velum_bench {
namespace {

std::string with_spread(const Timing& timing) {
  const int digits = timing.median < 9.995 ? 2 : timing.median < 999.5 ? 1 : 0;
  if (timing.frames == 1) return fixed(timing.median, digits) + " (1 frame)";
  return fixed(timing.median, digits) + " ±" + fixed(timing.spread() / 2.0, digits);
}

std::string coverage_text(const Row& row) {
  if (!row.same_coverage) return "–";
  return fixed(100.0 * *row.same_coverage, 4) + " %" + (row.agrees() ? "" : " FAIL");
}

void add_timing(std::ostream& line, const std::optional<Timing>& timing) {
  if (!timing) {
    line << ",,,,,";
    return;
  }
  line << ',' << timing->median << ',' << timing->quarter << ',' << timing->three_quarters << ','
       << timing->first << ',' << timing->frames;
}

template <typename T>
void add_optional(std::ostream& line, const std::optional<T>& value) {
  line << ',';
  if (value) line << *value;
}

}  // namespace

Table table_of(const std::vector<Row>& rows) {
  Table table({"scene", "mode", "triangles", "velum ms", "llvmpipe ms", "ratio", "Mtri/s", "Mpixel/s", "MB",
               "same coverage"},
              "llrrrrrrrr");
  for (const Row& row : rows) {
    table.add({row.scene, row.mode, std::to_string(row.triangles), with_spread(row.velum),
               row.llvmpipe ? with_spread(*row.llvmpipe) : "–",
               row.ratio() ? short_figure(*row.ratio()) : "–", short_figure(row.triangles_per_second() / 1e6),
               short_figure(row.pixels_per_second() / 1e6),
               row.memory ? fixed(static_cast<double>(*row.memory) / 1e6, 0) : "–", coverage_text(row)});
  }
  return table;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::ostringstream csv;
  csv << "scene,mode,triangles,left_out,vertices,pixels,bytes,velum_ms,velum_quarter_ms,velum_three_quarters_"
         "ms,"
         "velum_first_ms,velum_frames,llvmpipe_ms,llvmpipe_quarter_ms,llvmpipe_three_quarters_ms,"
         "llvmpipe_first_ms,llvmpipe_frames,ratio,triangles_per_s,pixels_per_s,memory_bytes,same_coverage\n";
  csv.precision(9);
  for (const Row& row : rows) {
    csv << row.scene << ',' << row.mode << ',' << row.triangles << ',' << row.left_out << ',' << row.vertices
        << ',' << row.pixels << ',' << row.bytes;
    add_timing(csv, row.velum);
    add_timing(csv, row.llvmpipe);
    add_optional(csv, row.ratio());
    csv << ',' << row.triangles_per_second() << ',' << row.pixels_per_second();
    add_optional(csv, row.memory);
    add_optional(csv, row.same_coverage);
    csv << '\n';
  }
  return csv.str();
}

}  // namespace velum_bench
