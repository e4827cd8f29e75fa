// The frozen CSV of docs/theory.md section 8, and its like for the families that came later.
#pragma once

#include <cstdio>

#include "section.hpp"

namespace restrip::generator {

/// One row for each valid configuration, ordered by place, then colours before, then ports; all decimal.
///   split:              k,a,loop,ports,inner,strips,isolated
///   collapse:           k,a,inner,ports,loop,strips,isolated
///   open-split:         k,i,j,loop,ports,inner,strips,isolated
///   open-collapse:      k,i,j,inner,ports,loop,strips,isolated
///   boundary-split:     k,i,loop,ports,inner,strips,isolated
///   boundary-collapse:  k,i,inner,ports,loop,strips,isolated
///   flip:               inner,ports,inner_after,ports_after,strips,isolated   (k is not used)
void dump(Family family, unsigned k, std::FILE* out);

}  // namespace restrip::generator
