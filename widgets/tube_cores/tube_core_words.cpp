#include "widgets/tube_cores/tube_core_words.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tubeCores", text); }

}  // namespace

TubeCoreStates::TubeCoreStates(const AdaptiveOtf* run) {
    if (run == nullptr) return;
    double largest = 0.0;
    for (const TubeCore& tube : run->tubes) largest = std::max(largest, tube.d);
    for (std::size_t t = 0; t < run->tubes.size(); ++t) {
        states.push_back(stateOf(*run, static_cast<int>(t)));
        shares.push_back(largest > 0.0 ? run->tubes[t].d / largest : 0.0);
    }
}

QString wordsOf(TubeState state) {
    const std::string_view name = nameOf(state);
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

QString lineOf(const AdaptiveOtf& run, int number) {
    const TubeCore& tube = run.tubes.at(static_cast<std::size_t>(number));
    QString line = tr("Tube core %1: column %2, row %3, %4")
                       .arg(number)
                       .arg(tube.column)
                       .arg(tube.row)
                       .arg(wordsOf(stateOf(run, number)));
    if (tube.d > 0.0) line += tr(", d %1").arg(QLocale::c().toString(tube.d, 'g', 3));
    return line;
}

}  // namespace echolucent
