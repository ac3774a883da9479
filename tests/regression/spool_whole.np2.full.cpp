// spool_ranks for the whole run.
#include "spool_ranks.np1_2.cpp"
