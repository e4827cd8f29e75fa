// Bad input: the program exits with code 2 and one sentence that names the file and the remedy.
#pragma once

#include "common/reading.hpp"

namespace restrip::tools {

/// The input is at fault, not the program. The text follows FileError and includes the position if that helps.
using BadInput = files::FileError;

}  // namespace restrip::tools
