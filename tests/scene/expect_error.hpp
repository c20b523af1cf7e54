#pragma once

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

#include "base/error.hpp"

/// Demands that `action` throws an Error of this kind whose text has every one of `parts`.
template <typename Action>
void expect_error(velum::ErrorKind kind, std::initializer_list<std::string> parts, Action&& action) {
  try {
    action();
  } catch (const velum::Error& error) {
    CHECK(error.kind() == kind);
    const std::string text = error.what();
    for (const std::string& part : parts) CHECK_MESSAGE(text.find(part) != std::string::npos, text);
    return;
  }
  FAIL_CHECK("no Error was thrown");
}
