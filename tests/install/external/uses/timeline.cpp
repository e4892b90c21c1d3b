#include <morphcl/timeline.hpp>

bool use_timeline() {
  const morphcl::Timeline timeline;
  validate(timeline);
  return morphcl::evaluate(timeline, 3).frame == 3;
}
