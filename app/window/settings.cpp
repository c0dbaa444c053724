#include "app/window/settings.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <cmath>
#include <optional>
#include <string_view>

#include "processing/adaptive/method_parameters.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {
namespace {

constexpr auto recentFilesKey = "recent/files";
constexpr auto lastFolderKey = "recent/folder";
constexpr auto lastSaveFolderKey = "recent/saveFolder";
constexpr auto numbersForNamesKey = "window/numbersForNames";
constexpr auto studyNumbersKey = "recent/studyNumbers";
constexpr auto geometryKey = "window/geometry";
constexpr auto stateKey = "window/state";
constexpr auto rendererKey = "picture/renderer";
constexpr auto themeKey = "window/theme";
constexpr auto paneLayoutKey = "window/paneLayout";
constexpr auto presetsOpenKey = "picture/presetsOpen";
constexpr auto histogramKey = "otfEditor/histogramLogarithmic";
constexpr auto pingPongKey = "motion/pingPong";
constexpr auto phasesPingPongKey = "motion/phasesPingPong";
constexpr auto motionSpeedKey = "motion/speed";
constexpr auto motionOtfKey = "motion/otf";
constexpr auto motionAxisKey = "motion/axis";
constexpr auto activeCurveKey = "otfEditor/activeCurve";
constexpr auto initialKey = "method/initial";
constexpr auto initialScaleKey = "method/initialScale";

QString absolutePath(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

/// "true" or "false" as written by QSettings; anything else is not understood.
bool boolOr(const QVariant& value, bool otherwise) {
    const QString text = value.toString();
    if (text == "true") return true;
    return text == "false" ? false : otherwise;
}

template <typename Values>
QString settingKey(const QString& group, const Parameter<Values>& row) {
    return group + '/' + QString::fromStdString(camelCase(row.name));
}

QString settingKey(const Parameter<Look>& row) { return settingKey("picture", row); }

/// A stored value of the kind of `standard`; nothing where it is not understood.
std::optional<ParameterValue> valueOf(const QVariant& stored, const ParameterValue& standard,
                                      const ParameterRange& range) {
    const QString text = stored.toString();
    if (std::holds_alternative<std::string>(standard)) return text.toStdString();
    if (std::holds_alternative<bool>(standard))
        return text == "true" || text == "false" ? std::optional<ParameterValue>(text == "true") : std::nullopt;
    bool understood = false;
    const double number = stored.toDouble(&understood);
    if (!understood || !inRange(number, range)) return std::nullopt;
    if (std::holds_alternative<std::int64_t>(standard)) return static_cast<std::int64_t>(std::llround(number));
    return number;
}

QVariant storedOf(const ParameterValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    if (const auto* choice = std::get_if<std::string>(&value)) return textOf(*choice);
    return *numberOf(value);
}

ParameterRange initialScaleRange() { return parameterNamed(methodParameters(), "opacity_scale")->range; }

/// The choice that a stored name names, or the standard one.
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
    Look look = lookAtStart();
    for (const Parameter<Look>& row : lookParameters()) {
        if (!chosenByPersons(row)) continue;
        // Files of before 0.2 know depth colours by another key.
        const QVariant older = row.name == "depth_colouring" ? m_store.value("picture/depthColoured") : QVariant();
        if (const auto value = valueOf(m_store.value(settingKey(row), older), *row.get(Look{}), row.range))
            row.set(look, *value);
    }
    return look;
}
void Settings::setLook(const Look& look) {
    for (const Parameter<Look>& row : lookParameters()) {
        if (!chosenByPersons(row)) continue;
        m_store.setValue(settingKey(row), storedOf(*row.get(look)));
    }
}

RendererChoice Settings::renderer() const {
    return rendererFromName(m_store.value(rendererKey).toString().toStdString()).value_or(RendererChoice::automatic);
}
void Settings::setRenderer(RendererChoice renderer) { m_store.setValue(rendererKey, textOf(nameOf(renderer))); }

bool Settings::histogramLogarithmic() const { return boolOr(m_store.value(histogramKey), true); }
void Settings::setHistogramLogarithmic(bool logarithmic) { m_store.setValue(histogramKey, logarithmic); }
Theme Settings::theme() const { return choiceOr(m_store.value(themeKey), &themeFromName, Theme::dark); }
void Settings::setTheme(Theme theme) { m_store.setValue(themeKey, textOf(nameOf(theme))); }
PaneLayout Settings::paneLayout() const {
    return paneLayoutFromName(m_store.value(paneLayoutKey).toString().toStdString()).value_or(PaneLayout::only3d);
}
void Settings::setPaneLayout(PaneLayout layout) { m_store.setValue(paneLayoutKey, textOf(nameOf(layout))); }

QString Settings::presetsFile() const {
    const QFileInfo file(m_store.fileName());
    return file.dir().filePath(file.completeBaseName() + QStringLiteral("-presets.json"));
}
QString Settings::autosaveFolder() const { return m_dataFolder + QStringLiteral("/autosaves"); }
QString Settings::recentPicturesFolder() const { return m_dataFolder + QStringLiteral("/recent"); }
bool Settings::presetsOpen() const { return boolOr(m_store.value(presetsOpenKey), false); }
void Settings::setPresetsOpen(bool open) { m_store.setValue(presetsOpenKey, open); }

MotionChoice Settings::motion() const {
    const MotionChoice standard;
    MotionChoice motion{.axis = choiceOr(m_store.value(motionAxisKey), &motionAxisFromName, standard.axis),
                        .otf = choiceOr(m_store.value(motionOtfKey), &motionOtfFromName, standard.otf),
                        .pingPong = boolOr(m_store.value(pingPongKey), standard.pingPong),
                        .phasesPingPong = boolOr(m_store.value(phasesPingPongKey), standard.phasesPingPong),
                        .speed = m_store.value(motionSpeedKey, standard.speed).toDouble()};
    if (!problemOf(motion).empty()) motion.speed = standard.speed;
    return motion;
}
void Settings::setMotion(const MotionChoice& motion) {
    m_store.setValue(motionAxisKey, textOf(nameOf(motion.axis)));
    m_store.setValue(motionOtfKey, textOf(nameOf(motion.otf)));
    m_store.setValue(pingPongKey, motion.pingPong);
    m_store.setValue(phasesPingPongKey, motion.phasesPingPong);
    m_store.setValue(motionSpeedKey, motion.speed);
}

CurveKind Settings::activeCurve() const {
    return choiceOr(m_store.value(activeCurveKey), &curveKindFromName, CurveKind::adaptive);
}
void Settings::setActiveCurve(CurveKind kind) { m_store.setValue(activeCurveKey, textOf(nameOf(kind))); }

MethodChoice Settings::method() const {
    MethodChoice method;
    method.initial = choiceOr(m_store.value(initialKey), &initialKindFromName, method.initial);
    const ParameterValue scale =
        valueOf(m_store.value(initialScaleKey), method.initialScale, initialScaleRange()).value_or(method.initialScale);
    method.initialScale = *numberOf(scale);
    // The choices stand first in the table, so that what applies to them alone is read after them.
    for (const Parameter<AdaptiveOtfConfig>& row : methodParameters()) {
        const auto standard = row.get(method.config);
        if (!standard) continue;
        if (const auto value = valueOf(m_store.value(settingKey("method", row)), *standard, row.range))
            row.set(method.config, *value);
    }
    method.config.initial = AdaptiveOtfConfig{}.initial;
    if (!problemOf(method.config).empty()) method.config = AdaptiveOtfConfig{};
    return method;
}
void Settings::setMethod(const MethodChoice& method) {
    m_store.remove("method");  // what belongs to a choice that was left is not kept
    m_store.setValue(initialKey, textOf(nameOf(method.initial)));
    m_store.setValue(initialScaleKey, method.initialScale);
    for (const Parameter<AdaptiveOtfConfig>& row : methodParameters())
        if (const auto value = row.get(method.config)) m_store.setValue(settingKey("method", row), storedOf(*value));
}

bool Settings::save() { return m_store.save(); }

}  // namespace echolucent
