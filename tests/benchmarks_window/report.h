// The tables and the JSON file of the window's benchmark.
#pragma once

#include <QList>
#include <optional>

#include "tests/benchmarks_window/heartbeat.h"
#include "tests/benchmarks_window/measures.h"
#include "tests/benchmarks_window/memory.h"
#include "tests/benchmarks_window/opening_time.h"
#include "widgets/panels/motion_panel.h"

namespace echolucent::bench {

struct Findings {
    QList<Row> rows;
    Memory memory;           ///< of a study with everything on
    QList<KeptMotion> kept;  ///< of each cine
    QList<Stall> stalls;
    std::optional<OpeningTimes> opening;
};

[[nodiscard]] QString tableHeader();
[[nodiscard]] QString tableLine(const Row& row);
/// A sentence.
[[nodiscard]] QString memoryLine(const Memory& memory);
/// A sentence.
[[nodiscard]] QString keptLine(const KeptMotion& kept);
/// A table with a line for each stall, and a sentence that names the longest.
[[nodiscard]] QString stallTable(const QList<Stall>& stalls);

/// {"processors": n, "rows": [...], "memory": {...}, "kept": [...], "stalls": [...], "opening": {...}}. False if it
/// cannot be written.
[[nodiscard]] bool writeJson(const QString& path, const Findings& findings);

}  // namespace echolucent::bench
