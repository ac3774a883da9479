// All five turns of the reel: what reel_ranks tests of the first.
#include "reel_ranks.np1_2_3.cpp"
