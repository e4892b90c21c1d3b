// What every failing run of the tool has in common.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run_tool.hpp"

namespace morphcl::cli_test {

// Fails unless the run ended with `code`, nothing on stdout and exactly one line "morphcl: ..." on stderr that holds
// `part`.
inline void expect_one_line_error(const ToolResult& result, int code, const std::string& part) {
  EXPECT_EQ(result.code, code) << result.err;
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.out, "");
  ASSERT_EQ(result.err_lines().size(), 1u) << result.err;
  EXPECT_THAT(result.err, testing::StartsWith("morphcl: "));
  EXPECT_THAT(result.err, testing::HasSubstr(part));
}

}  // namespace morphcl::cli_test
