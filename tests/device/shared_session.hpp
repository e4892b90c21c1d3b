// One session for all tests of a process; opening takes PoCL 20 ms.
#pragma once

#include <memory>

#include "morphcl/session.hpp"

namespace morphcl::testing {

inline Session& shared_session() {
  static const std::shared_ptr<Session> session = Session::open({});
  return *session;
}

}  // namespace morphcl::testing
