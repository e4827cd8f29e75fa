// What the program says when it cannot use what it was given: exit code 2, and one sentence with the file and the
// remedy.
#pragma once

#include "common/file_error.hpp"

namespace restrip::tools {

/// The input is at fault, not the program; the text is as FileError says, with the place where that helps.
using BadInput = files::FileError;

}  // namespace restrip::tools
