// Prints what the table of the family answers, for the verifier.
#include "restrip/tables/operation_dump.hpp"
#include "restrip/tables/operations/remove_vertex.hpp"

int main() { return restrip::tables::print_dump("remove-vertex", restrip::tables::remove_vertex); }
