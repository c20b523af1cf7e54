// velum diff A B: how far two pictures are apart.
#include <cmath>
#include <iostream>
#include <memory>
#include <variant>
#include <velum/velum.hpp>

#include "input_picture.hpp"
#include "json_values.hpp"
#include "parse_values.hpp"
#include "text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct DiffOptions {
  std::string a;
  std::string b;
  std::string heat;
  std::string max_diff = "0";
  std::string max_pixels = "0";
  bool json = false;
};

constexpr const char* footer =
    "Differences are per channel: of 8-bit pictures in codes 0 ... 255, alpha too; of PFM in its own unit,\n"
    "with PSNR for a peak of 1. Exit codes: 0 within the limits, 1 outside, 2 usage, 3 unreadable or of\n"
    "different size.\n"
    "Examples:\n"
    "  velum diff before.png after.png\n"
    "  velum diff before.png after.png -o heat.png     where they differ: the lighter, the more\n"
    "  velum diff a.pfm b.pfm --max-diff 1e-5 --max-pixels 20 --json";

/// What was found, and the heat map.
struct Finding {
  int width = 0;
  int height = 0;
  ImageDifference difference;
  Image<Rgba8> heat;
};

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

template <typename Pixel>
Finding compared(const Image<Pixel>& a, const Image<Pixel>& b, const DiffOptions& o, double threshold) {
  if (a.width() != b.width() || a.height() != b.height()) {
    throw Error(ErrorKind::read,
                "the pictures differ in size: " + size_text(a.width(), a.height()) + " and " +
                    size_text(b.width(), b.height()),
                o.a + ", " + o.b, "compare pictures of one size");
  }
  Finding finding{a.width(), a.height(), compare(a.view(), b.view(), threshold), {}};
  if (!o.heat.empty()) finding.heat = heat_map(a.view(), b.view());
  return finding;
}

Finding compare_files(const DiffOptions& o, double threshold) {
  const InputPicture a = read_picture(o.a);
  const InputPicture b = read_picture(o.b);
  if (a.index() != b.index()) {
    throw Error(ErrorKind::read,
                std::string("the first holds ") + content_of(a) + ", the second " + content_of(b),
                o.a + ", " + o.b, "compare pictures of one kind");
  }
  return std::visit(
      [&](const auto& first) {
        using Picture = std::decay_t<decltype(first)>;
        return compared(first, std::get<Picture>(b), o, threshold);
      },
      a);
}

/// JSON has no infinity: null.
Json finite_json(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const Finding& finding, const DiffOptions& o, double threshold, bool within) {
  const ImageDifference& d = finding.difference;
  return {{"a", o.a},
          {"b", o.b},
          {"width", finding.width},
          {"height", finding.height},
          {"same_bytes", d.same_bytes},
          {"max", finite_json(d.max)},
          {"mean", finite_json(d.mean)},
          {"rmse", finite_json(d.rmse)},
          {"psnr", finite_json(d.psnr)},
          {"pixels_over", d.pixels_over},
          {"worst", d.max > 0.0 ? Json{d.worst_x, d.worst_y} : Json(nullptr)},
          {"max_diff", threshold},
          {"max_pixels", number_from(o.max_pixels, "--max-pixels")},
          {"within_limits", within}};
}

std::string measure_text(double value) {
  return std::isinf(value) ? "infinite" : number_text(value, 5);
}

void print_text(std::ostream& out, const Finding& finding, const DiffOptions& o, double threshold,
                bool within) {
  const ImageDifference& d = finding.difference;
  out << o.a << " and " << o.b << ": " << size_text(finding.width, finding.height) << ", ";
  if (d.same_bytes) {
    out << "equal to the byte\n";
    return;
  }
  out << counted_text(d.pixels_over, "pixel") << " with a difference over " << number_text(threshold)
      << (within ? ", within the limits\n" : ", outside the limits\n");
  if (d.max > 0.0) {
    out << "  largest difference " << measure_text(d.max) << ", first at (" << d.worst_x << ", " << d.worst_y
        << ")\n";
  }
  out << "  mean " << measure_text(d.mean) << ", RMSE " << measure_text(d.rmse) << ", PSNR "
      << measure_text(d.psnr) << (std::isinf(d.psnr) ? "\n" : " dB\n");
}

double limit_from(const std::string& text, const std::string& option) {
  const double limit = number_from(text, option);
  if (limit >= 0.0) return limit;
  throw Error(ErrorKind::usage, "\"" + text + "\" is negative", option, "give 0 or more");
}

void check_usage(const DiffOptions& o) {
  if (o.a == "-" && o.b == "-") {
    throw Error(ErrorKind::usage, "both pictures are standard input", "A, B", "give a file for one of them");
  }
  const std::string extension = std::filesystem::path(o.heat).extension().string();
  if (!o.heat.empty() && o.heat != "-" && extension != ".png") {
    throw Error(ErrorKind::usage, "\"" + o.heat + "\" does not end in .png", "-o", "the heat map is a PNG");
  }
}

int run(const DiffOptions& o) {
  check_usage(o);
  const double threshold = limit_from(o.max_diff, "--max-diff");
  const double most_pixels = limit_from(o.max_pixels, "--max-pixels");
  const Finding finding = compare_files(o, threshold);
  const bool within = static_cast<double>(finding.difference.pixels_over) <= most_pixels;
  if (!o.heat.empty()) write_png(o.heat, finding.heat);
  std::ostream& out = o.heat == "-" ? std::cerr : std::cout;
  if (o.json) {
    out << json_text(json_of(finding, o, threshold, within));
  } else {
    print_text(out, finding, o, threshold, within);
  }
  return within ? exit_ok : exit_different;
}

}  // namespace

Verb add_diff(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("diff", "Compare two pictures");
  const auto options = std::make_shared<DiffOptions>();
  parser->add_option("A", options->a, "A picture (PNG, PPM, PFM), or - for standard input")
      ->required()
      ->type_name("");
  parser->add_option("B", options->b, "Another of the same size")->required()->type_name("");
  parser->add_option("-o", options->heat, "Write a heat map: where they differ, and how much")
      ->type_name("HEAT.png");
  parser
      ->add_option("--max-diff", options->max_diff,
                   "Largest difference of a channel that does not count; default 0")
      ->type_name("N");
  parser->add_option("--max-pixels", options->max_pixels, "So many pixels may differ by more; default 0")
      ->type_name("N");
  parser->add_flag("--json", options->json, "Print JSON; null stands for infinity");
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
