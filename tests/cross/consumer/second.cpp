#include <restrip/restrip.hpp>

static_assert(restrip::split_rule({4, 2}, 0b0101, 0).valid);

std::size_t strips_elsewhere(const restrip::StripMesh& mesh) { return restrip::extract_strips(mesh).size(); }
