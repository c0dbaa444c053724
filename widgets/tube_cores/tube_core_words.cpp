#include "widgets/tube_cores/tube_core_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tubeCores", text); }

}  // namespace

QString wordsOf(TubeState state) {
    switch (state) {
        case TubeState::weighs: return tr("weighs");
        case TubeState::weighsNothing: return tr("no weight");
        case TubeState::noSurface: return tr("no surface");
        case TubeState::outside: return tr("outside");
        case TubeState::neverPlaced: return tr("never placed");
    }
    return {};
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
