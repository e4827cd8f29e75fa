#include "commands/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "certify/certificate.hpp"
#include "describe/description.hpp"
#include "solve/section.hpp"
#include "tables/layout.hpp"

namespace restrip::generator {

Order order_of(const std::vector<std::string>& files, std::optional<unsigned> max_k) {
  Order order{read_descriptions(files), false, max_k.value_or(default_max_k)};
  const bool has_family = std::any_of(order.descriptions.begin(), order.descriptions.end(),
                                      [](const Description& one) { return !one.numbers.empty(); });
  if (max_k && !has_family)
    throw std::runtime_error(
        fmt::format("{}: not a family, so --max-k has no effect; leave it out", fmt::join(files, ", ")));
  return order;
}

std::vector<std::filesystem::path> names_of(const Order& order) {
  return order.shipped ? names_of_tables(order.descriptions, order.languages)
                       : names_of_operations(order.descriptions, order.languages);
}

Emitted make(const Order& order, const std::vector<Patches>& patches) {
  const std::vector<Certificate> certificates =
      certify(solve_all(patches, order.threads), order.threads, order.languages.contains("c++"));
  if (order.shipped) return emit_tables(certificates, pack(certificates, order.max_k), order.max_k, order.languages);
  return emit_operations(certificates, operation_layouts(certificates, order.descriptions, order.max_k),
                         order.languages);
}

}  // namespace restrip::generator
