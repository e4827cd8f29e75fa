// Index buffers of a StripMesh.
#include "restrip/output/impl/strip_format.hpp"
#include "restrip/output/live_buffer.hpp"

namespace restrip {

template void LiveBuffer::rebuild(const StripMesh&);
template Upload LiveBuffer::update(const StripMesh&, std::span<const std::uint32_t>, const RangeOptions&);
template void StripBuffer::rebuild(const StripMesh&);
template std::span<const IndexRange> StripBuffer::update(const StripMesh&, std::span<const std::uint32_t>,
                                                         const RangeOptions&);

}  // namespace restrip
