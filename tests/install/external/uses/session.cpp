#include <morphcl/session.hpp>

bool use_session() {
  const auto session = morphcl::Session::open({});
  return session->verdict() == morphcl::Verdict::identical && !morphcl::list_devices().empty();
}
