// Prints the answers of the family's table, for the verifier.
#include "restrip/tables/operation_dump.hpp"
#include "restrip/tables/operations/remove_vertex.hpp"

int main() { return restrip::tables::print_dump("remove-vertex", restrip::tables::remove_vertex_rules); }
