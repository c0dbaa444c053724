// The table and the JSON file of a benchmark's rows.
#pragma once

#include <QList>

#include "tests/benchmarks_window/measures.h"

namespace echolucent::bench {

[[nodiscard]] QString tableHeader();
[[nodiscard]] QString tableLine(const Row& row);

/// {"processors": n, "rows": [...]}; false where it cannot be written.
[[nodiscard]] bool writeJson(const QString& path, const QList<Row>& rows);

}  // namespace echolucent::bench
