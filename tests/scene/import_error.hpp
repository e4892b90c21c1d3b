// What an import is refused with.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "morphcl/error.hpp"

namespace morphcl::test {

// Runs `import`, which must throw Error of `kind` whose one line begins with `place` and holds `words`.
inline void expect_refusal(const std::function<void()>& import, ErrorKind kind, const std::string& place,
                           const std::string& words) {
  try {
    import();
  } catch (const Error& error) {
    const std::string line = error.what();
    EXPECT_EQ(error.exit_code(), static_cast<int>(kind)) << line;
    EXPECT_EQ(line.substr(0, place.size() + 2), place + ": ") << line;
    EXPECT_NE(line.find(words), std::string::npos) << "expected: " << words << "\nactual:   " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return;
  }
  ADD_FAILURE() << "not refused; expected: " << place << ": ... " << words;
}

}  // namespace morphcl::test
