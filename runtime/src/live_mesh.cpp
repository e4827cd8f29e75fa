// LiveMesh.
#include "restrip/live_mesh.hpp"

#include "restrip/impl/live_mesh.hpp"
