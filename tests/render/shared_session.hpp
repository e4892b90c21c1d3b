// One device session for all tests of a program: opening one and compiling kernels takes a second.
#pragma once

#include <gtest/gtest.h>

#include "morphcl/session.hpp"

namespace morphcl::test {

// Stores what was compiled when the tests have run: each test is a process of its own, and those that follow find it.
class SharedSession : public ::testing::Environment {
 public:
  static const std::shared_ptr<Session>& get() {
    if (!session()) {
      prepare_process(0);
      session() = Session::open({});
    }
    return session();
  }
  void TearDown() override {
    if (session()) session()->store_programs();
  }

 private:
  static std::shared_ptr<Session>& session() {
    static std::shared_ptr<Session> opened;
    return opened;
  }
};

inline ::testing::Environment* const shared_session_environment =
    ::testing::AddGlobalTestEnvironment(new SharedSession);  // GoogleTest owns it

inline std::shared_ptr<Session> shared_session() { return SharedSession::get(); }

}  // namespace morphcl::test
