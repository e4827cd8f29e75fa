#include <restrip/restrip.hpp>

static_assert(restrip::split_rule({4, 2}, 0b0101, 0).valid);

std::size_t strips_elsewhere(const restrip::StripMesh& mesh) { return restrip::extract_strips(mesh).size(); }

bool splits_elsewhere(restrip::LiveMesh& live) { return live.split({live.edge(0, 1), live.edge(0, 2)}).granted(); }
