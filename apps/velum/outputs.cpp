#include "outputs.hpp"

#include <algorithm>
#include <string_view>
#include <velum/image/visibility_buffer.hpp>

#include "text.hpp"

namespace velum_app {
namespace {

using namespace velum;
namespace fs = std::filesystem;

/// The extensions that an output is written in; the first is also the form of "-" where that is allowed.
std::vector<std::string_view> extensions_of(OutputKind kind) {
  switch (kind) {
    case OutputKind::colour:
      return {".png", ".ppm"};
    case OutputKind::depth:
    case OutputKind::metric_depth:
    case OutputKind::normals:
      return {".pfm", ".npy"};
    case OutputKind::object_ids:
    case OutputKind::triangle_ids:
      return {".npy", ".png"};
    case OutputKind::report:
      return {".json"};
    case OutputKind::page:
      return {".html", ".htm"};
  }
  return {};
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

bool has_extension(const Output& output, std::string_view extension) {
  return extension_of(output.path) == extension;
}

std::string joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : " or ") + std::string(name);
  return text;
}

void check_extension(const Output& output) {
  const auto known = extensions_of(output.kind);
  if (output.path == "-" || std::any_of(known.begin(), known.end(), [&output](std::string_view extension) {
        return has_extension(output, extension);
      })) {
    return;
  }
  if (output.path.has_parent_path() && !output.path.has_filename()) {
    throw Error(ErrorKind::usage, "\"" + output.path.string() + "\" names a folder", output.option,
                "give the name of a file in it that ends in " + joined(known));
  }
  throw Error(ErrorKind::usage, "cannot tell the format of \"" + output.path.string() + "\"", output.option,
              "give a name that ends in " + joined(known));
}

void check_folder(const Output& output) {
  const fs::path folder = output.path.parent_path();
  std::error_code ignored;
  if (fs::is_directory(output.path, ignored)) {
    throw Error(ErrorKind::write, "is a folder", output.path.string(), "give the name of a file in it");
  }
  if (folder.empty() || fs::is_directory(folder, ignored)) return;
  throw Error(ErrorKind::write, "there is no folder \"" + folder.string() + "\"", output.path.string(),
              "make it, or give another name");
}

void check_png_size(const fs::path& path, const Size& size, bool opaque, const std::string& remedy) {
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  if (pixels * (opaque ? 3 : 4) <= largest_png_bytes) return;
  throw Error(ErrorKind::usage,
              std::to_string(size.width) + "x" + std::to_string(size.height) +
                  " pixels are more than a PNG can be written with (" +
                  grouped_text(largest_png_bytes / (opaque ? 3 : 4)) + ")",
              path == "-" ? "standard output" : path.string(), remedy);
}

void check_png_size_of(const Output& output, const Size& size, bool opaque) {
  const bool is_standard_output = output.path == "-" && output.kind == OutputKind::colour;
  if (!is_standard_output && !has_extension(output, ".png")) return;
  if (output.kind == OutputKind::colour) {
    check_png_size(output.path, size, opaque, "write .ppm, or ask for a crop or a smaller picture");
  } else {
    check_png_size(output.path, size, false, "write .npy, or ask for a crop or a smaller picture");
  }
}

/// Ids as a picture for the eye: a distinct colour each, the background transparent.
Image<Rgba8> coloured(ImageView<const std::uint32_t> ids) {
  Image<Rgba8> picture(ids.width, ids.height, Rgba8{0, 0, 0, 0});
  for (int y = 0; y < ids.height; ++y) {
    for (int x = 0; x < ids.width; ++x) {
      const std::uint32_t id = ids.at(x, y);
      if (id != no_primitive) picture.at(x, y) = srgb_from_linear(id_colour(id));
    }
  }
  return picture;
}

template <typename T>
void write_numbers(const Output& output, const Image<T>& image) {
  if (has_extension(output, ".npy")) {
    write_npy(output.path, image.view());
  } else {
    write_pfm(output.path, image.view());
  }
}

void write_ids(const Output& output, const Image<std::uint32_t>& ids) {
  if (has_extension(output, ".png")) {
    write_png(output.path, coloured(ids.view()).view());
  } else {
    write_npy(output.path, ids.view());
  }
}

void write_colour(const Output& output, const Image<Rgba8>& colour) {
  if (has_extension(output, ".ppm")) {
    write_ppm(output.path, colour.view());
  } else {
    write_png(output.path, colour.view());
  }
}

}  // namespace

void check_outputs(const std::vector<Output>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    check_extension(outputs[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (outputs[i].path.lexically_normal() == outputs[j].path.lexically_normal()) {
        throw Error(ErrorKind::usage,
                    "\"" + outputs[i].path.string() + "\" is also the output of " + outputs[j].option,
                    outputs[i].option, "give each output a place of its own");
      }
    }
  }
  for (const Output& output : outputs) check_folder(output);
}

void check_json_is_alone(const std::vector<Output>& outputs, bool prints_json) {
  for (const Output& output : outputs) {
    if (!prints_json || output.path != "-") continue;
    throw Error(ErrorKind::usage, "the JSON goes to standard output", output.option,
                "give the name of a file, or leave --json out");
  }
}

void check_png_sizes(const std::vector<Output>& outputs, const Size& size, bool opaque) {
  for (const Output& output : outputs) check_png_size_of(output, size, opaque);
}

void write_output(const Output& output, const Picture& picture) {
  switch (output.kind) {
    case OutputKind::colour:
      return write_colour(output, picture.colour);
    case OutputKind::depth:
      return write_numbers(output, picture.depth);
    case OutputKind::metric_depth:
      return write_numbers(output, picture.metric_depth);
    case OutputKind::normals:
      return write_numbers(output, picture.normal);
    case OutputKind::object_ids:
      return write_ids(output, picture.object_id);
    case OutputKind::triangle_ids:
      return write_ids(output, picture.triangle_id);
    case OutputKind::report:
    case OutputKind::page:
      return;
  }
}

void write_drawing(const Output& output, const Image<Rgba8>& drawing) {
  write_colour(output, drawing);
}

}  // namespace velum_app
