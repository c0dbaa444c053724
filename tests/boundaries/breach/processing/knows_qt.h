// A breach on purpose: the include check must see it.
#include <QString>
