// Declarations of the classes that a program names in its own headers: enough for parameters, and for members behind a
// pointer.
#pragma once

#include "restrip/precondition.hpp"

namespace restrip {

class StripMesh;
class LiveMesh;
struct LiveOptions;
struct BakedFile;
class LiveBuffer;
template <class Mesh>
class Keeper;

}  // namespace restrip
