#pragma once

#include "verb.hpp"

namespace velum_app {

Verb add_claims(CLI::App& program);

}  // namespace velum_app
