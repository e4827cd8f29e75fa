#pragma once
// Work that several threads share: on_threads().

#include "common/share.hpp"
