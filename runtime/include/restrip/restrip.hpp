// restrip: maintains triangle strips while a mesh changes, by proven rules. C++20, standard library only.
//
// Start with live_mesh.hpp (mesh, strips and index buffer in one object), with search/strips_of.hpp for a mesh that
// does not change, or with mesh/strip_mesh.hpp and search/keeper.hpp for the parts. Each folder includes only folders
// named before it in this list; the two folders of a line do not include each other.
//
//   rules/                   look a rule up: constexpr, knows no mesh
//   mesh/                    StripMesh, checks of preconditions, walks
//   operations/, output/     operations with strips kept; strips and index buffers out
//   search/, formats/        searches beyond a patch: strips from scratch, keepers with a policy; reading files
//   live_mesh.hpp            all of it in one object
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#error "restrip needs C++20: compile with -std=c++20 (MSVC: /std:c++20) or a later standard"
#else

#include "restrip/formats/baked_file.hpp"
#include "restrip/fwd.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/split_record.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/triangle_list.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/output/trace.hpp"
#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/key.hpp"
#include "restrip/rules/rules.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/search/strips_of.hpp"

#endif  // C++20
