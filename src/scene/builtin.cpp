#include "builtin.hpp"

#include <string>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"

namespace velum {
namespace {

struct BuiltinShape {
  std::string_view name;
  Mesh (*make)();
};

constexpr BuiltinShape k_shapes[] = {
    {"tetrahedron", [] { return shapes::tetrahedron(); }},
    {"cube", [] { return shapes::cube(); }},
    {"octahedron", [] { return shapes::octahedron(); }},
    {"dodecahedron", [] { return shapes::dodecahedron(); }},
    {"icosahedron", [] { return shapes::icosahedron(); }},
    {"box", [] { return shapes::box(); }},
    {"sphere", [] { return shapes::sphere(); }},
    {"icosphere", [] { return shapes::icosphere(); }},
    {"cylinder", [] { return shapes::cylinder(); }},
    {"cone", [] { return shapes::cone(); }},
    {"torus", [] { return shapes::torus(); }},
    {"grid", [] { return shapes::grid(); }},
    {"stairs", [] { return shapes::stairs(); }},
    {"house", [] { return shapes::house(); }},
    {"letter-f", [] { return shapes::letter_f(); }},
};

}  // namespace

std::vector<std::string_view> builtin_names() {
  std::vector<std::string_view> names;
  for (const BuiltinShape& shape : k_shapes) names.push_back(shape.name);
  return names;
}

Mesh builtin_shape(std::string_view name) {
  const FloatingPointScope floating_point;
  std::string known;
  for (const BuiltinShape& shape : k_shapes) {
    if (shape.name == name) return shape.make();
    known += (known.empty() ? "" : ", ") + std::string(shape.name);
  }
  throw Error(ErrorKind::usage, "there is no such built-in shape", "builtin:" + std::string(name),
              "known are " + known);
}

}  // namespace velum
