// A circle that no file sees: first.h is read by second.cpp, and second.h by first.h.
#include "processing/second.h"
