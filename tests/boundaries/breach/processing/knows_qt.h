// A deliberate breach: the include check must see it.
#include <QString>
