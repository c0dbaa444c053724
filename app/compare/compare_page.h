// A comparison as one HTML page that opens without a network.
#pragma once

#include <QImage>
#include <QString>
#include <string>
#include <vector>

#include "processing/classification.h"
#include "widgets/compare/compare_rows.h"

namespace echolucent {

struct ComparePage {
    QString study;  ///< as names are shown
    QString made, version;
    struct Pane {
        std::size_t place = 0;  ///< in the comparison
        CompareRow row;
        QImage image;
        Classification classification = ManualCurve{};
        std::vector<std::string> explanation{};  ///< of its designer
    };
    std::vector<Pane> panes;
};

[[nodiscard]] std::string comparePageText(const ComparePage& page);

}  // namespace echolucent
