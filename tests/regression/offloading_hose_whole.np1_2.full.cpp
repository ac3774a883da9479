// All 400 s of the offloading hose: what offloading_hose tests of its beginning.
#include "offloading_hose.np1_2.cpp"
