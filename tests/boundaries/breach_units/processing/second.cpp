#include "processing/second.h"

#include "processing/first.h"
