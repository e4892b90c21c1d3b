// One device session for all tests of a program: opening one and compiling kernels takes a second.
#pragma once

#include "host/device/session.hpp"

namespace morphcl::test {

inline std::shared_ptr<Session> shared_session() {
  static const std::shared_ptr<Session> session = [] {
    prepare_process(0);
    return Session::open({});
  }();
  return session;
}

}  // namespace morphcl::test
