// Processes, which WebAssembly does not have: none can be started (module.cpp).
#pragma once
#include <stdio.h>

inline bool WIFEXITED(int /*status*/) { return true; }
inline int WEXITSTATUS(int status) { return status; }
extern "C" FILE* popen(const char* command, const char* mode);
extern "C" int pclose(FILE* stream);
