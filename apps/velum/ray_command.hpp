#pragma once

#include "verb.hpp"

namespace velum_app {

/// `velum ray`: what the ray through a pixel meets, and how it is found.
Verb add_ray(CLI::App& program);

}  // namespace velum_app
