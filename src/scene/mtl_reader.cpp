#include "mtl_reader.hpp"

#include <algorithm>
#include <optional>

#include "text_scanner.hpp"

namespace velum {
namespace {

// A material as the file states it; what it means follows from all statements together.
struct MtlStatements {
  Material material;
  std::optional<glm::vec3> ambient, filter;
  std::optional<float> alpha, transparency;
  std::optional<std::int64_t> illumination;
  bool has_diffuse = false;
};

float clamped_share(float value) {
  if (!(value > 0.0f)) return 0.0f;
  return std::min(value, 1.0f);
}

float largest_channel(const glm::vec3& v) {
  return clamped_share(std::max({v.x, v.y, v.z}));
}

glm::vec3 ambient_share(const glm::vec3& ambient, const glm::vec3& base) {
  if (ambient == glm::vec3(0.0f)) return glm::vec3(1.0f);
  glm::vec3 share(1.0f);
  for (int i = 0; i < 3; ++i) {
    if (base[i] > 0.0f) share[i] = clamped_share(ambient[i] / base[i]);
  }
  return share;
}

Material material_of(const MtlStatements& read) {
  Material material = read.material;
  if (!read.has_diffuse && !material.base_colour_texture.empty()) material.base_colour = glm::vec3(1.0f);
  if (read.ambient) material.ambient = ambient_share(*read.ambient, material.base_colour);
  if (read.alpha)
    material.alpha = clamped_share(*read.alpha);
  else if (read.transparency)
    material.alpha = 1.0f - clamped_share(*read.transparency);
  const std::int64_t model = read.illumination.value_or(2);
  if (model >= 3 && model <= 7) material.mirror_share = largest_channel(material.specular);
  if (model == 4 || model == 6 || model == 7 || model == 9) {
    material.transmission_share = read.filter ? largest_channel(*read.filter) : 1.0f - material.alpha;
  }
  if (model == 0 || model == 1) material.specular = glm::vec3(0.0f);
  return material;
}

class MtlParser {
 public:
  MtlParser(std::string_view text, const std::string& name, const std::filesystem::path& directory,
            MaterialLibrary& library)
      : scanner_(text, name, {'#', true}), directory_(directory), library_(library) {}

  void parse(std::vector<std::string>& notes);

 private:
  void finish();
  void statement(std::string_view keyword);
  bool colour_statement(std::string_view keyword);
  std::optional<glm::vec3> colour();
  float number() { return scanner_.number(scanner_.token(), "a value"); }
  std::string_view texture_name(TextureMapping& mapping);
  void texture_option(std::string_view option, TextureMapping& mapping);
  void leave_out(std::string_view keyword);

  TextScanner scanner_;
  const std::filesystem::path& directory_;
  MaterialLibrary& library_;
  std::optional<MtlStatements> current_;
  std::size_t left_out_ = 0;
  std::string first_left_out_;
};

void MtlParser::parse(std::vector<std::string>& notes) {
  while (!scanner_.at_end()) {
    const std::string_view keyword = scanner_.token();
    if (equal_ignoring_case(keyword, "newmtl")) {
      finish();
      current_.emplace();
      current_->material.name = std::string(scanner_.rest_of_line());
    } else if (!keyword.empty()) {
      if (!current_) scanner_.fail("a statement before the first newmtl: " + quoted(keyword));
      if (!colour_statement(keyword)) statement(keyword);
    }
    scanner_.next_line();
  }
  finish();
  if (left_out_ == 0) return;
  notes.push_back(std::to_string(left_out_) + " material statements are left out, the first is " +
                  first_left_out_);
}

void MtlParser::finish() {
  if (!current_) return;
  library_.try_emplace(current_->material.name, material_of(*current_));
}

bool MtlParser::colour_statement(std::string_view keyword) {
  const bool is_ambient = equal_ignoring_case(keyword, "Ka"), is_diffuse = equal_ignoring_case(keyword, "Kd");
  const bool is_specular = equal_ignoring_case(keyword, "Ks"), is_filter = equal_ignoring_case(keyword, "Tf");
  if (!is_ambient && !is_diffuse && !is_specular && !is_filter) return false;
  const std::optional<glm::vec3> value = colour();
  if (!value)
    leave_out(keyword);
  else if (is_ambient)
    current_->ambient = value;
  else if (is_diffuse) {
    current_->material.base_colour = *value;
    current_->has_diffuse = true;
  } else if (is_specular)
    current_->material.specular = *value;
  else
    current_->filter = value;
  return true;
}

void MtlParser::statement(std::string_view keyword) {
  Material& material = current_->material;
  if (equal_ignoring_case(keyword, "Ns"))
    material.shininess = std::max(0.0f, number());
  else if (equal_ignoring_case(keyword, "d")) {
    const std::string_view token = scanner_.token();
    current_->alpha = scanner_.number(token == "-halo" ? scanner_.token() : token, "a value");
  } else if (equal_ignoring_case(keyword, "Tr"))
    current_->transparency = number();
  else if (equal_ignoring_case(keyword, "Ni")) {
    const float index = number();
    if (index > 0.0f && index - index == 0.0f) material.refractive_index = index;
  } else if (equal_ignoring_case(keyword, "illum")) {
    current_->illumination = scanner_.integer(scanner_.token(), "the illumination model");
  } else if (equal_ignoring_case(keyword, "map_Kd")) {
    TextureMapping mapping;
    const std::string_view file = texture_name(mapping);
    if (file.empty()) return;
    material.base_colour_texture = beside(directory_, file).generic_string();
    material.texture_mapping = mapping;
  } else {
    leave_out(keyword);
  }
}

// One number means all channels; "spectral" and "xyz" are other spaces and are left out.
std::optional<glm::vec3> MtlParser::colour() {
  const std::string_view first = scanner_.token();
  if (equal_ignoring_case(first, "spectral") || equal_ignoring_case(first, "xyz")) return std::nullopt;
  glm::vec3 value(scanner_.number(first, "a colour"));
  const std::string_view second = scanner_.token();
  if (!second.empty()) {
    value.y = scanner_.number(second, "a colour");
    value.z = scanner_.number(scanner_.token(), "a colour");
  }
  for (int i = 0; i < 3; ++i) {
    if (!(value[i] - value[i] == 0.0f)) scanner_.fail("a colour is not finite");
    value[i] = std::max(0.0f, value[i]);
  }
  return value;
}

// map_Kd [-option arguments …] file name, which may hold blanks.
std::string_view MtlParser::texture_name(TextureMapping& mapping) {
  while (true) {
    TextScanner ahead = scanner_;
    const std::string_view option = ahead.token();
    if (option.size() < 2 || option[0] != '-') return scanner_.rest_of_line();
    scanner_ = ahead;
    texture_option(option, mapping);
  }
}

// -o, -s and -t take one to three numbers, across, up and in depth; -mm takes two arguments, all others one.
void MtlParser::texture_option(std::string_view option, TextureMapping& mapping) {
  const bool takes_vector = option == "-o" || option == "-s" || option == "-t";
  const int arguments = takes_vector ? 3 : option == "-mm" ? 2 : 1;
  for (int i = 0; i < arguments; ++i) {
    TextScanner ahead = scanner_;
    const std::string_view argument = ahead.token();
    const std::optional<float> value = parse_float(argument);
    if (takes_vector && i > 0 && !value) return;
    scanner_ = ahead;
    if (option == "-clamp" && argument == "on") mapping.wrap.fill(TextureWrap::clamp);
    if (!value || i > 1) continue;
    if (option == "-o") mapping.offset[i] = *value;
    if (option == "-s") mapping.scale[i] = *value;
  }
}

void MtlParser::leave_out(std::string_view keyword) {
  if (left_out_++ == 0) first_left_out_ = quoted(keyword) + " at " + scanner_.where();
}

}  // namespace

void read_mtl(std::string_view text, const std::string& name, const std::filesystem::path& directory,
              MaterialLibrary& library, std::vector<std::string>& notes) {
  MtlParser(text, name, directory, library).parse(notes);
}

std::filesystem::path beside(const std::filesystem::path& directory, std::string_view named) {
  std::string portable(named);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  const bool has_drive = portable.size() > 1 && portable[1] == ':';
  const std::filesystem::path path(portable);
  return directory / (path.is_absolute() || has_drive ? path.filename() : path);
}

}  // namespace velum
