#include "app/settings/settings.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/document/value_text.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {
namespace {

constexpr auto recentFilesKey = "recent/files";
constexpr auto lastFolderKey = "recent/folder";
constexpr auto lastSaveFolderKey = "recent/saveFolder";
constexpr auto numbersForNamesKey = "window/numbersForNames";
constexpr auto studyNumbersKey = "recent/studyNumbers";
constexpr auto leftSessionsKey = "recent/leftSessionsPutAway";
constexpr auto geometryKey = "window/geometry";
constexpr auto stateKey = "window/state";
constexpr auto rendererKey = "picture/renderer";
constexpr auto themeKey = "window/theme";
constexpr auto faceKey = "window/face";
constexpr auto paneLayoutKey = "window/paneLayout";
constexpr auto sidesTakenKey = "picture/sidesTaken";
constexpr auto sidesShownKey = "picture/sidesShown";
constexpr auto presetsOpenKey = "picture/presetsOpen";
constexpr auto histogramKey = "otfEditor/histogramLogarithmic";
constexpr auto earlyLightKey = "otfEditor/earlyLight";
constexpr auto activeCurveKey = "otfEditor/activeCurve";
// These hold JSON as documents have it (io/document/value_text.h).
constexpr auto lookKey = "picture/look";
constexpr auto motionKey = "motion/choice";
constexpr auto methodKey = "method/choice";

QString absolutePath(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

/// "true" or "false" as written by QSettings; anything else is not understood.
bool boolOr(const QVariant& value, bool otherwise) {
    const QString text = value.toString();
    if (text == "true") return true;
    return text == "false" ? false : otherwise;
}

// Settings of 0.1 have a key for each row of a table, "picture/colourMap". Each is read by itself.

template <typename Values>
QString keyOf01(const char* group, const Parameter<Values>& row) {
    return QStringLiteral("%1/%2").arg(group, QString::fromStdString(camelCase(row.name)));
}

/// A stored value of the kind of `like`; no value if it is not understood.
std::optional<ParameterValue> valueOf01(const QVariant& stored, const ParameterValue& like,
                                        const ParameterRange& range) {
    const QString text = stored.toString();
    if (std::holds_alternative<std::string>(like)) return text.toStdString();
    if (std::holds_alternative<bool>(like))
        return text == "true" || text == "false" ? std::optional<ParameterValue>(text == "true") : std::nullopt;
    bool understood = false;
    const double number = stored.toDouble(&understood);
    if (!understood || !inRange(number, range)) return std::nullopt;
    if (std::holds_alternative<std::int64_t>(like)) return static_cast<std::int64_t>(std::llround(number));
    return number;
}

/// Takes the stored values in the table's order: there a choice stands before the parameters that belong to it.
template <typename Values>
void takeKeysOf01(const SettingsStore& store, const char* group, const ParameterTable<Values>& table, Values& values) {
    for (const Parameter<Values>& row : table)
        if (const auto like = row.get(values))
            if (const auto value = valueOf01(store.value(keyOf01(group, row)), *like, row.range))
                row.set(values, *value);
}

template <typename Values>
void removeKeysOf01(SettingsStore& store, const char* group, const ParameterTable<Values>& table) {
    for (const Parameter<Values>& row : table) store.remove(keyOf01(group, row));
}

/// The choice of a stored name, or the standard one.
template <typename Choice>
Choice choiceOr(const QVariant& stored, std::optional<Choice> (*fromName)(std::string_view), Choice standard) {
    return fromName(stored.toString().toStdString()).value_or(standard);
}

QString sessionNumberKey(const QString& path) {
    return QStringLiteral("recent/sessionNumbers/") + Settings::hashOf(path);
}

}  // namespace

Settings::Settings(const QString& file)
    : m_store(file.isEmpty()
                  ? QSettings(QSettings::IniFormat, QSettings::UserScope, "Echolucent", "Echolucent").fileName()
                  : file) {
    const QFileInfo given(file);
    m_dataFolder = file.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                                  : given.absoluteDir().filePath(given.completeBaseName() + QStringLiteral("-data"));
}

QStringList Settings::keptRecentFiles() const { return m_store.value(recentFilesKey).toStringList(); }

QStringList Settings::recentFiles() const {
    QStringList present;
    for (const QString& path : keptRecentFiles()) {
        if (QFileInfo::exists(path)) present << path;
    }
    return present;
}

void Settings::addRecentFile(const QString& path) {
    if (path.isEmpty()) return;
    QStringList paths = keptRecentFiles();
    const QString added = absolutePath(path);
    paths.removeAll(added);
    paths.prepend(added);
    m_store.setValue(recentFilesKey, QStringList(paths.mid(0, recentFilesLimit)));
}

void Settings::clearRecentFiles() { m_store.remove(recentFilesKey); }

bool Settings::numbersForNames() const { return boolOr(m_store.value(numbersForNamesKey), false); }
void Settings::setNumbersForNames(bool numbers) { m_store.setValue(numbersForNamesKey, numbers); }

int Settings::studyNumber(const QString& path) {
    if (const int ofStudy = m_store.value(sessionNumberKey(path)).toInt(); ofStudy > 0) return ofStudy;
    QStringList known = m_store.value(studyNumbersKey).toStringList();
    const QString hash = hashOf(path);
    if (const qsizetype place = known.indexOf(hash); place >= 0) return static_cast<int>(place) + 1;
    known << hash;
    m_store.setValue(studyNumbersKey, known);
    return static_cast<int>(known.size());
}

void Settings::setStudyOfSession(const QString& session, const QString& study) {
    m_store.setValue(sessionNumberKey(session), studyNumber(study.isEmpty() ? session : study));
}

bool Settings::isSession(const QString& path) const { return m_store.contains(sessionNumberKey(path)); }

QString Settings::dataFolder() const { return m_dataFolder; }

QString Settings::hashOf(const QString& path) {
    const QByteArray digest = QCryptographicHash::hash(absolutePath(path).toUtf8(), QCryptographicHash::Sha256);
    return QString::fromLatin1(digest.toHex().first(16));
}

QString Settings::lastFolder() const { return m_store.value(lastFolderKey).toString(); }
void Settings::setLastFolder(const QString& folder) { m_store.setValue(lastFolderKey, folder); }
QString Settings::lastSaveFolder() const { return m_store.value(lastSaveFolderKey, lastFolder()).toString(); }
void Settings::setLastSaveFolder(const QString& folder) { m_store.setValue(lastSaveFolderKey, folder); }

QByteArray Settings::windowGeometry() const { return m_store.value(geometryKey).toByteArray(); }
void Settings::setWindowGeometry(const QByteArray& geometry) { m_store.setValue(geometryKey, geometry); }
QByteArray Settings::windowState() const { return m_store.value(stateKey).toByteArray(); }
void Settings::setWindowState(const QByteArray& state) { m_store.setValue(stateKey, state); }

Look Settings::look() const {
    Look look = lookParameters().standard;
    if (m_store.contains(lookKey)) {
        look = lookFromText(m_store.value(lookKey).toString().toStdString());
    } else {
        takeKeysOf01(m_store, "picture", lookParameters(), look);
    }
    look.step = Look{}.step;  // the quality sets it
    return look;
}
void Settings::setLook(const Look& look) {
    removeKeysOf01(m_store, "picture", lookParameters());
    m_store.setValue(lookKey, QString::fromStdString(textOf(look)));
}

RendererChoice Settings::renderer() const {
    return rendererFromName(m_store.value(rendererKey).toString().toStdString()).value_or(RendererChoice::automatic);
}
void Settings::setRenderer(RendererChoice renderer) { m_store.setValue(rendererKey, textOf(nameOf(renderer))); }

bool Settings::histogramLogarithmic() const { return boolOr(m_store.value(histogramKey), true); }
void Settings::setHistogramLogarithmic(bool logarithmic) { m_store.setValue(histogramKey, logarithmic); }
bool Settings::earlyLightShown() const { return boolOr(m_store.value(earlyLightKey), false); }
void Settings::setEarlyLightShown(bool shown) { m_store.setValue(earlyLightKey, shown); }
Theme Settings::theme() const { return choiceOr(m_store.value(themeKey), &themeFromName, Theme::dark); }
void Settings::setTheme(Theme theme) { m_store.setValue(themeKey, textOf(nameOf(theme))); }
Face Settings::face() const { return choiceOr(m_store.value(faceKey), &faceFromName, Face::review); }
void Settings::setFace(Face face) { m_store.setValue(faceKey, textOf(nameOf(face))); }
PaneLayout Settings::paneLayout() const {
    return paneLayoutFromName(m_store.value(paneLayoutKey).toString().toStdString()).value_or(PaneLayout::only3d);
}
void Settings::setPaneLayout(PaneLayout layout) { m_store.setValue(paneLayoutKey, textOf(nameOf(layout))); }

QString Settings::presetsFile() const {
    const QFileInfo file(m_store.fileName());
    return file.dir().filePath(file.completeBaseName() + QStringLiteral("-presets.json"));
}
QString Settings::autosaveFolder() const { return m_dataFolder + QStringLiteral("/autosaves"); }
QStringList Settings::leftSessionsPutAway() const { return m_store.value(leftSessionsKey).toStringList(); }
void Settings::setLeftSessionsPutAway(const QStringList& files) { m_store.setValue(leftSessionsKey, files); }
QString Settings::recentPicturesFolder() const { return m_dataFolder + QStringLiteral("/recent"); }

QMap<QString, QString> Settings::sidesTaken() const {
    // Kinds and words in turn, the newest last.
    const QStringList stored = m_store.value(sidesTakenKey).toStringList();
    QMap<QString, QString> taken;
    for (qsizetype i = 0; i + 1 < stored.size(); i += 2) taken.insert(stored[i], stored[i + 1]);
    return taken;
}

void Settings::setSideTaken(const QString& kind, const QString& word) {
    constexpr qsizetype mostKinds = 50;
    QStringList stored = m_store.value(sidesTakenKey).toStringList(), next;
    for (qsizetype i = 0; i + 1 < stored.size(); i += 2)
        if (stored[i] != kind) next << stored[i] << stored[i + 1];
    if (!word.isEmpty()) next << kind << word;
    while (next.size() > 2 * mostKinds) next.remove(0, 2);
    if (next != stored) m_store.setValue(sidesTakenKey, next);
}

bool Settings::sidesShown() const { return boolOr(m_store.value(sidesShownKey), true); }
void Settings::setSidesShown(bool shown) { m_store.setValue(sidesShownKey, shown); }
bool Settings::presetsOpen() const { return boolOr(m_store.value(presetsOpenKey), false); }
void Settings::setPresetsOpen(bool open) { m_store.setValue(presetsOpenKey, open); }

namespace {

/// Without what moves and the phases, which belong to the study. Axes of older programs belong to their documents.
MotionChoice rememberedOf(const MotionChoice& motion) {
    return {.axis = screenAxisOf(motion.axis),
            .otf = motion.otf,
            .pingPong = motion.pingPong,
            .phasesPingPong = motion.phasesPingPong,
            .speed = motion.speed};
}

constexpr std::array motionKeysOf01{"motion/axis", "motion/otf", "motion/pingPong", "motion/phasesPingPong",
                                    "motion/speed"};

MotionChoice motionOf01(const SettingsStore& store) {
    const auto& [axis, otf, pingPong, phasesPingPong, speed] = motionKeysOf01;
    const MotionChoice standard;
    MotionChoice motion{.axis = choiceOr(store.value(axis), &motionAxisFromName, standard.axis),
                        .otf = choiceOr(store.value(otf), &motionOtfFromName, standard.otf),
                        .pingPong = boolOr(store.value(pingPong), standard.pingPong),
                        .phasesPingPong = boolOr(store.value(phasesPingPong), standard.phasesPingPong),
                        .speed = store.value(speed, standard.speed).toDouble()};
    if (!problemOf(motion).empty()) motion.speed = standard.speed;
    return motion;
}

}  // namespace

MotionChoice Settings::motion() const {
    if (!m_store.contains(motionKey)) return rememberedOf(motionOf01(m_store));
    return rememberedOf(motionFromText(m_store.value(motionKey).toString().toStdString()));
}
void Settings::setMotion(const MotionChoice& motion) {
    for (const char* key : motionKeysOf01) m_store.remove(key);
    m_store.setValue(motionKey, QString::fromStdString(textOf(rememberedOf(motion))));
}

CurveKind Settings::activeCurve() const {
    return choiceOr(m_store.value(activeCurveKey), &curveKindFromName, CurveKind::adaptive);
}
void Settings::setActiveCurve(CurveKind kind) { m_store.setValue(activeCurveKey, textOf(nameOf(kind))); }

MethodChoice Settings::method() const {
    if (m_store.contains(methodKey)) return methodFromText(m_store.value(methodKey).toString().toStdString());
    MethodChoice method;
    // Keys of 0.1 mean the curve of that version.
    const bool of01 = std::ranges::any_of(methodParameters(),
                                          [&](const auto& row) { return m_store.contains(keyOf01("method", row)); });
    if (of01) method.config = configOf(MethodReading::firstVersion);
    const AdaptiveOtfConfig standard = method.config;
    takeKeysOf01(m_store, "method", initialFunctionParameters(), method);
    takeKeysOf01(m_store, "method", methodParameters(), method.config);
    method.config.initial = AdaptiveOtfConfig{}.initial;
    if (!problemOf(method.config).empty()) method.config = standard;
    return method;
}
void Settings::setMethod(const MethodChoice& method) {
    removeKeysOf01(m_store, "method", initialFunctionParameters());
    removeKeysOf01(m_store, "method", methodParameters());
    MethodChoice remembered = method;
    remembered.config.grid.withoutTubes.clear();  // a matter of the study
    m_store.setValue(methodKey, QString::fromStdString(textOf(remembered)));
}

bool Settings::save() { return m_store.save(); }

}  // namespace echolucent
