#include "app/window/settings.h"

#include <QDir>
#include <QFileInfo>
#include <optional>
#include <string_view>

#include "widgets/panels/panel_controls.h"

namespace echolucent {
namespace {

constexpr auto recentFilesKey = "recent/files";
constexpr auto lastFolderKey = "recent/folder";
constexpr auto geometryKey = "window/geometry";
constexpr auto stateKey = "window/state";
constexpr auto rendererKey = "picture/renderer";
constexpr auto paneLayoutKey = "window/paneLayout";
constexpr auto histogramKey = "otfEditor/histogramLogarithmic";
constexpr auto pingPongKey = "motion/pingPong";

QString absolutePath(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

/// "true" or "false" as written by QSettings; anything else is not understood.
bool boolOr(const QVariant& value, bool otherwise) {
    const QString text = value.toString();
    if (text == "true") return true;
    return text == "false" ? false : otherwise;
}

QString keyOf(const Parameter<Look>& row) { return "picture/" + QString::fromStdString(camelCase(row.name)); }

/// A stored value of the kind that the row has; nothing where it is not understood.
std::optional<ParameterValue> valueOf(const QVariant& stored, const Parameter<Look>& row) {
    const QString text = stored.toString();
    const ParameterValue standard = *row.get(Look{});
    if (std::holds_alternative<std::string>(standard)) return text.toStdString();
    if (std::holds_alternative<bool>(standard))
        return text == "true" || text == "false" ? std::optional<ParameterValue>(text == "true") : std::nullopt;
    bool understood = false;
    const double number = stored.toDouble(&understood);
    if (!understood || !inRange(number, row.range)) return std::nullopt;
    return number;
}

}  // namespace

Settings::Settings(const QString& file)
    : m_store(file.isEmpty()
                  ? QSettings(QSettings::IniFormat, QSettings::UserScope, "Echolucent", "Echolucent").fileName()
                  : file,
              QSettings::IniFormat) {}

QStringList Settings::recentFiles() const {
    QStringList present;
    for (const QString& path : m_store.value(recentFilesKey).toStringList()) {
        if (QFileInfo::exists(path)) present << path;
    }
    return present;
}

void Settings::addRecentFile(const QString& path) {
    if (path.isEmpty()) return;
    QStringList paths = m_store.value(recentFilesKey).toStringList();
    const QString added = absolutePath(path);
    paths.removeAll(added);
    paths.prepend(added);
    m_store.setValue(recentFilesKey, QStringList(paths.mid(0, recentFilesLimit)));
}

void Settings::clearRecentFiles() { m_store.remove(recentFilesKey); }

QString Settings::lastFolder() const { return m_store.value(lastFolderKey).toString(); }
void Settings::setLastFolder(const QString& folder) { m_store.setValue(lastFolderKey, folder); }

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
        if (const auto value = valueOf(m_store.value(keyOf(row), older), row)) row.set(look, *value);
    }
    return look;
}
void Settings::setLook(const Look& look) {
    for (const Parameter<Look>& row : lookParameters()) {
        if (!chosenByPersons(row)) continue;
        const ParameterValue value = *row.get(look);
        if (const auto* flag = std::get_if<bool>(&value))
            m_store.setValue(keyOf(row), *flag);
        else if (const auto* choice = std::get_if<std::string>(&value))
            m_store.setValue(keyOf(row), textOf(*choice));
        else
            m_store.setValue(keyOf(row), *numberOf(value));
    }
}

RendererChoice Settings::renderer() const {
    return rendererFromName(m_store.value(rendererKey).toString().toStdString()).value_or(RendererChoice::automatic);
}
void Settings::setRenderer(RendererChoice renderer) { m_store.setValue(rendererKey, textOf(nameOf(renderer))); }

bool Settings::histogramLogarithmic() const { return boolOr(m_store.value(histogramKey), true); }
void Settings::setHistogramLogarithmic(bool logarithmic) { m_store.setValue(histogramKey, logarithmic); }
PaneLayout Settings::paneLayout() const {
    return paneLayoutFromName(m_store.value(paneLayoutKey).toString().toStdString()).value_or(PaneLayout::only3d);
}
void Settings::setPaneLayout(PaneLayout layout) { m_store.setValue(paneLayoutKey, textOf(nameOf(layout))); }

bool Settings::motionPingPong() const { return boolOr(m_store.value(pingPongKey), true); }
void Settings::setMotionPingPong(bool pingPong) { m_store.setValue(pingPongKey, pingPong); }

bool Settings::save() {
    m_store.sync();
    return m_store.status() == QSettings::NoError;
}

}  // namespace echolucent
