// That a call refuses its arguments, with a message that holds `text`.
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <string>

#include "morphcl/error.hpp"

namespace morphcl::testing {

inline void expect_usage_error(const std::function<void()>& call, const std::string& text) {
  try {
    call();
    ADD_FAILURE() << "accepted; expected: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), ::testing::HasSubstr(text));
  }
}

}  // namespace morphcl::testing
