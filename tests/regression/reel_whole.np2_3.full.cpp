// reel_ranks for all five turns.
#include "reel_ranks.np1_2_3.cpp"
