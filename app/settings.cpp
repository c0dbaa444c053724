#include "app/settings.h"

#include <QDir>
#include <QFileInfo>
#include <cmath>
#include <string_view>

namespace echolucent {
namespace {

constexpr auto recentFilesKey = "recent/files";
constexpr auto lastFolderKey = "recent/folder";
constexpr auto geometryKey = "window/geometry";
constexpr auto stateKey = "window/state";
constexpr auto colourMapKey = "picture/colourMap";
constexpr auto interpolationKey = "picture/interpolation";
constexpr auto projectionKey = "picture/projection";
constexpr auto modeKey = "picture/mode";
constexpr auto shadedKey = "picture/shaded";
constexpr auto lightAzimuthKey = "picture/lightAzimuth";
constexpr auto lightElevationKey = "picture/lightElevation";
constexpr auto depthColouredKey = "picture/depthColoured";
constexpr auto rendererKey = "picture/renderer";
constexpr auto histogramKey = "otfEditor/histogramLogarithmic";
constexpr auto pingPongKey = "motion/pingPong";

QString absolutePath(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

QString asText(std::string_view name) { return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())); }

/// "true" or "false" as written by QSettings; anything else is not understood.
bool boolOr(const QVariant& value, bool otherwise) {
    const QString text = value.toString();
    if (text == "true") return true;
    return text == "false" ? false : otherwise;
}

/// A number of degrees within +- largest.
double degreesOr(const QVariant& value, double largest, double otherwise) {
    bool understood = false;
    const double degrees = value.toDouble(&understood);
    return understood && std::abs(degrees) <= largest ? degrees : otherwise;
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

void Settings::removeRecentFile(const QString& path) {
    QStringList paths = m_store.value(recentFilesKey).toStringList();
    paths.removeAll(absolutePath(path));
    m_store.setValue(recentFilesKey, paths);
}

void Settings::clearRecentFiles() { m_store.remove(recentFilesKey); }

QString Settings::lastFolder() const { return m_store.value(lastFolderKey).toString(); }
void Settings::setLastFolder(const QString& folder) { m_store.setValue(lastFolderKey, folder); }

QByteArray Settings::windowGeometry() const { return m_store.value(geometryKey).toByteArray(); }
void Settings::setWindowGeometry(const QByteArray& geometry) { m_store.setValue(geometryKey, geometry); }
QByteArray Settings::windowState() const { return m_store.value(stateKey).toByteArray(); }
void Settings::setWindowState(const QByteArray& state) { m_store.setValue(stateKey, state); }

ColourMap Settings::colourMap() const {
    return colourMapFromName(m_store.value(colourMapKey).toString().toStdString()).value_or(ColourMap::sepia);
}
void Settings::setColourMap(ColourMap map) { m_store.setValue(colourMapKey, asText(nameOf(map))); }

Interpolation Settings::interpolation() const {
    return m_store.value(interpolationKey).toString() == "nearest" ? Interpolation::nearest : Interpolation::trilinear;
}
void Settings::setInterpolation(Interpolation interpolation) {
    m_store.setValue(interpolationKey, interpolation == Interpolation::nearest ? "nearest" : "trilinear");
}

Projection Settings::projection() const {
    return m_store.value(projectionKey).toString() == "perspective" ? Projection::perspective : Projection::parallel;
}
void Settings::setProjection(Projection projection) {
    m_store.setValue(projectionKey, projection == Projection::perspective ? "perspective" : "parallel");
}

RenderMode Settings::mode() const {
    return renderModeFromName(m_store.value(modeKey).toString().toStdString()).value_or(RenderMode::direct);
}
void Settings::setMode(RenderMode mode) { m_store.setValue(modeKey, asText(nameOf(mode))); }

LightDirection Settings::light() const {
    const LightDirection usual;
    return {degreesOr(m_store.value(lightAzimuthKey), 180.0, usual.azimuthDegrees),
            degreesOr(m_store.value(lightElevationKey), 90.0, usual.elevationDegrees)};
}
void Settings::setLight(const LightDirection& light) {
    m_store.setValue(lightAzimuthKey, light.azimuthDegrees);
    m_store.setValue(lightElevationKey, light.elevationDegrees);
}

bool Settings::depthColoured() const { return boolOr(m_store.value(depthColouredKey), false); }
void Settings::setDepthColoured(bool coloured) { m_store.setValue(depthColouredKey, coloured); }

PreferredRenderer Settings::renderer() const {
    return preferredRendererFromName(m_store.value(rendererKey).toString().toStdString())
        .value_or(PreferredRenderer::automatic);
}
void Settings::setRenderer(PreferredRenderer renderer) { m_store.setValue(rendererKey, asText(nameOf(renderer))); }

bool Settings::shaded() const { return boolOr(m_store.value(shadedKey), true); }
void Settings::setShaded(bool shaded) { m_store.setValue(shadedKey, shaded); }
bool Settings::histogramLogarithmic() const { return boolOr(m_store.value(histogramKey), true); }
void Settings::setHistogramLogarithmic(bool logarithmic) { m_store.setValue(histogramKey, logarithmic); }
bool Settings::motionPingPong() const { return boolOr(m_store.value(pingPongKey), true); }
void Settings::setMotionPingPong(bool pingPong) { m_store.setValue(pingPongKey, pingPong); }

bool Settings::save() {
    m_store.sync();
    return m_store.status() == QSettings::NoError;
}

}  // namespace echolucent
