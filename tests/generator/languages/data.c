#define RESTRIP_TABLES_IMPLEMENTATION
#include "restrip_tables.h"
