// The sections of one certificate of the shipped families.
#pragma once

#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

inline std::vector<Section> solved(const std::string& certificate, unsigned max_k, unsigned threads) {
  std::vector<Patches> patches = patches_of(families(), max_k);
  std::erase_if(patches, [&](const Patches& one) { return one.certificate != certificate; });
  return solve_all(patches, threads);
}

}  // namespace restrip::generator
