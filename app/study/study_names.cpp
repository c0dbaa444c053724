#include "app/study/study_names.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>

#include "app/settings/settings.h"
#include "io/document/session_file.h"
#include "processing/one_line.h"

namespace echolucent {

namespace {

const QString leftOut = QStringLiteral("…");

QString oneLineOf(const QString& name) { return QString::fromStdString(oneLine(name.toStdString())); }

/// The replacement for the name of a file that is not a study.
QString endingOf(const QString& path) {
    const QString ending = QFileInfo(path).suffix();
    return ending.isEmpty() ? leftOut : QStringLiteral("*.") + ending;
}

/// Whether the piece is not part of a longer word or number: in "0.20240131" the digits name nobody.
bool standsAlone(const QString& text, qsizetype at, qsizetype length) {
    const auto isDigit = [&](qsizetype place) { return place >= 0 && place < text.size() && text[place].isDigit(); };
    const auto isPoint = [&](qsizetype place) {
        return place >= 0 && place < text.size() && QStringLiteral(".,").contains(text[place]);
    };
    const qsizetype end = at + length;
    const bool begins = at == 0 || !text[at - 1].isLetterOrNumber();
    const bool ends = end == text.size() || !text[end].isLetterOrNumber();
    const bool afterPoint = isDigit(at) && isPoint(at - 1) && isDigit(at - 2);
    const bool beforePoint = isDigit(end - 1) && isPoint(end) && isDigit(end + 1);
    return begins && ends && !afterPoint && !beforePoint;
}

/// Whether the piece is a folder or a file within a path: "10" in "slices/10", "US" in "US/1.dcm".
bool isPartOfPath(const QString& text, qsizetype at, qsizetype length) {
    const auto isSlash = [&](qsizetype place) {
        return place >= 0 && place < text.size() && text[place] == QLatin1Char('/');
    };
    return isSlash(at - 1) || isSlash(at + length);
}

/// Whether the piece is part of the name of a file: "heart-adaptive.json", "slices/heart".
bool isPartOfName(const QString& text, qsizetype at, qsizetype length) {
    const bool continues = at + length + 1 < text.size() && QStringLiteral("._-").contains(text[at + length]) &&
                           text[at + length + 1].isLetterOrNumber();
    return continues || isPartOfPath(text, at, length);
}

}  // namespace

StudyNames::StudyNames(Settings& settings, QObject* parent)
    : QObject(parent), m_settings(settings), m_numbers(settings.numbersForNames()) {
    for (const QString& path : settings.keptRecentFiles()) know(path);
}

void StudyNames::showNumbers(bool numbers) {
    if (numbers == m_numbers) return;
    m_numbers = numbers;
    m_settings.setNumbersForNames(numbers);
    emit changed();
}

void StudyNames::knowSession(const QString& session, const QString& study) {
    m_settings.setStudyOfSession(session, study);
    know(session);
}

void StudyNames::know(const QString& path, const QStringList& files) {
    const int study = m_settings.studyNumber(path);
    m_studies.insert(path, study);
    for (const QString& file : files) m_files.insert(file, study);
    m_known.reset();
}

const std::vector<StudyNames::Known>& StudyNames::known() const {
    if (m_known) return *m_known;
    QHash<QString, int> names;
    const auto add = [&](const QString& name, int study) {
        constexpr qsizetype shortest = 2;  // a single letter names nobody
        if (name.size() >= shortest && !name.startsWith(QStringLiteral(".."))) names.insert(name, study);
    };
    for (auto file = m_files.begin(); file != m_files.end(); ++file) {
        const QString name = file.key().mid(file.key().lastIndexOf('/') + 1);
        add(name, file.value());
        add(name.left(name.lastIndexOf('.')), file.value());
    }
    for (auto path = m_studies.begin(); path != m_studies.end(); ++path) {
        const QFileInfo info(QDir::cleanPath(path.key()));
        for (const QString& name : {path.key(), info.absoluteFilePath(), info.absolutePath(), info.fileName(),
                                    info.completeBaseName(), info.baseName()})
            add(name, path.value());
    }
    m_known.emplace();
    for (auto name = names.begin(); name != names.end(); ++name)
        m_known->push_back({name.key(), name.value(), standingOf(name.key())});
    std::ranges::sort(*m_known, std::ranges::greater{}, [](const Known& each) { return each.name.size(); });
    return *m_known;
}

StudyNames::Standing StudyNames::standingOf(const QString& name) {
    constexpr qsizetype longWord = 4, longNumber = 6;  // a date or a person's number has 6 digits or more
    if (std::ranges::none_of(name, [](QChar letter) { return letter.isLetter(); }))
        return name.size() >= longNumber ? Standing::anywhere : Standing::inPaths;
    if (name.size() < longWord) return Standing::inPaths;
    const bool word = std::ranges::all_of(name, [](QChar letter) { return letter.isLower(); });
    return word ? Standing::inNames : Standing::anywhere;
}

QString StudyNames::numberOf(const QString& path) {
    return (m_settings.isSession(path) ? tr("Study %1 (session)") : tr("Study %1")).arg(m_settings.studyNumber(path));
}

QString StudyNames::given(const QString& name, const QString& instead) {
    if (m_numbers) return instead;
    m_given.insert(name, instead);
    return name;
}

QString StudyNames::nameOf(const QString& path) {
    return given(oneLineOf(QFileInfo(QDir::cleanPath(path)).fileName()), numberOf(path));
}

QString StudyNames::nameOfAsked(const QString& path) {
    return m_numbers ? numberOf(path) : oneLineOf(QFileInfo(QDir::cleanPath(path)).fileName());
}

QString StudyNames::beginningFor(const QString& path) const {
    if (path.isEmpty()) return tr("simulated-scan");
    if (m_numbers) return tr("study-%1").arg(m_settings.studyNumber(path));
    // Names have at most 255 bytes, and "-picture series-0001.png" or ".session.json" follows.
    constexpr qsizetype mostBytes = 200;
    QString name = QString::fromStdString(stemOfStudy(path.toStdString()));
    while (name.toUtf8().size() > mostBytes) name.chop(name.back().isLowSurrogate() ? 2 : 1);
    return name;
}

QString StudyNames::nameOfOther(const QString& path) {
    return given(oneLineOf(QFileInfo(path).fileName()), endingOf(path));
}

QString StudyNames::numbered(QString text) const {
    for (const Known& known : this->known()) {
        const QString number = tr("Study %1").arg(known.study);
        for (qsizetype at = 0; (at = text.indexOf(known.name, at)) >= 0;) {
            const qsizetype length = known.name.size();
            const bool stands = known.standing == Standing::anywhere  ? true
                                : known.standing == Standing::inNames ? isPartOfName(text, at, length)
                                                                      : isPartOfPath(text, at, length);
            const bool meant = stands && standsAlone(text, at, length);
            if (meant) text.replace(at, length, number);
            at += meant ? number.size() : length;
        }
    }
    return text;
}

QString StudyNames::shown(const QString& text) const {
    if (!m_numbers) return text;
    static const QRegularExpression path(QStringLiteral(R"((?<![\w/])/[^\s/"]+/[^\s"]*[^\s".,:;])"));
    return numbered(text).replace(path, leftOut);
}

QString StudyNames::shownOfFile(const QString& text) const {
    if (!m_numbers) return text;
    static const QRegularExpression file(QStringLiteral(R"([^\s/"“”]+\.([A-Za-z][A-Za-z0-9]{1,6})\b)"));
    return shown(text).replace(file, QStringLiteral("*.\\1"));
}

QString StudyNames::shownBefore(const QString& text) const {
    if (!m_numbers) return text;
    QStringList names = m_given.keys();
    std::ranges::sort(names, std::ranges::greater{}, [](const QString& name) { return name.size(); });
    QString without = text;
    for (const QString& name : names)
        for (qsizetype at = 0; (at = without.indexOf(name, at)) >= 0;) {
            const bool meant = standsAlone(without, at, name.size());
            if (meant) without.replace(at, name.size(), m_given[name]);
            at += meant ? m_given[name].size() : name.size();
        }
    return shownOfFile(without);
}

QString StudyNames::sentenceOf(const Failure& failure) {
    const QString path = QString::fromStdString(failure.file);
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QString instead = endingOf(path);
    if (m_studies.contains(absolute))
        instead = numberOf(absolute);
    else if (m_files.contains(absolute))
        instead = tr("Study %1").arg(m_files[absolute]);
    Failure shownFailure = failure;
    if (!path.isEmpty()) shownFailure.file = given(path, instead).toStdString();
    return shownOfFile(QString::fromStdString(shownFailure.sentence()));
}

}  // namespace echolucent
