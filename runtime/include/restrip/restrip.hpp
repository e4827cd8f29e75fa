// restrip: triangle strips kept while the mesh changes, by local repairs proven optimal. Header-only, C++20, standard
// library only.
//
// Start with operations.hpp (split, collapse, flip), mesh.hpp (what your mesh has to offer) and strip_mesh.hpp (a mesh
// of ours).
#pragma once

#include "restrip/adopt.hpp"
#include "restrip/baked.hpp"
#include "restrip/checked.hpp"
#include "restrip/checks.hpp"
#include "restrip/exact.hpp"
#include "restrip/keeper.hpp"
#include "restrip/key.hpp"
#include "restrip/linked.hpp"
#include "restrip/mesh.hpp"
#include "restrip/operations.hpp"
#include "restrip/precondition.hpp"
#include "restrip/refusal.hpp"
#include "restrip/rules.hpp"
#include "restrip/strip_buffer.hpp"
#include "restrip/strip_mesh.hpp"
#include "restrip/stripify.hpp"
#include "restrip/strips.hpp"
