// A circle of rooms that no unit sees: this room knows the other, which knows this one.
#include "processing/second/known.h"
