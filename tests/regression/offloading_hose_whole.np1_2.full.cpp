// offloading_hose for all 400 s.
#include "offloading_hose.np1_2.cpp"
