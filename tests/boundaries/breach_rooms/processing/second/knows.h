// The other room knows this one, and this one knows the other.
#include "processing/first/known.h"
