// A circle that no single file shows: second.cpp includes first.h, and first.h includes second.h.
#include "processing/second.h"
