#pragma once
// Checks the certificate of a bound on indices against the triangles that it speaks of: docs/bound.md says what it
// claims and why that is a bound.

#include <cstdint>
#include <stdexcept>
#include <string>

#include "bound/triangle_list.hpp"

namespace restrip::verify {

/// A certificate that is well formed and claims what is not so; names file, line and reason.
class FalseBound : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ProvenBound {
  std::uint64_t cuts = 0;
  std::uint64_t indices = 0;  ///< no index buffer of the triangles has fewer
};

/// Throws InputError when the file is not of the format, and FalseBound.
ProvenBound check_bound(const std::string& certificate, const TriangleList& list);

}  // namespace restrip::verify
