// The whole of what spool_ranks does the first turn of.
#include "spool_ranks.np1_2.cpp"
