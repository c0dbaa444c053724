// A ProgressiveCaster over a caster that a test commands.
#pragma once

#include <QObject>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "processing/picture/converged.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/test_volumes.h"
#include "widgets/casting/progressive_caster.h"

namespace echolucent {

using testing::geometryOf;
using testing::volumeOf;

/// Stands in for a ray caster. Its pictures have one grey: the curve's opacity at full intensity. Tests can hold it up.
class CommandedCaster {
public:
    CastResult operator()(const PictureRequest& request, const Progress& progress) {
        std::unique_lock lock(m_mutex);
        if (request.panes.empty()) {
            ++m_lettingGo;
            m_changed.notify_all();
            return {};
        }
        m_started.push_back(request.settings);
        m_changed.notify_all();
        m_changed.wait(lock, [&] { return !m_held; });
        while (request.settings.width == m_endlessWidth && request.settings.step == convergedStep &&
               !progress.cancelled()) {
            lock.unlock();
            std::this_thread::yield();
            lock.lock();
        }
        if (progress.cancelled()) return {};
        const int width = request.settings.width, height = request.settings.height;
        const auto level = static_cast<float>(opacityAt(request.panes.front().classification, 1.0, 0.0));
        const Picture picture{
            width, height, std::vector<float>(static_cast<std::size_t>(4 * width * height), level), {}};
        CastPane pane{std::make_shared<const Picture>(picture),
                      std::make_shared<const ScreenPicture>(screenPicture(picture))};
        return {{std::move(pane)}, SampleUse::taken};
    }
    void hold() {
        set([this] { m_held = true; });
    }
    void letGo() {
        set([this] { m_held = false; });
    }
    /// From now on converged pictures of that width end only when they are cancelled.
    void convergedOnlyEndsCancelled(int width) {
        set([&] { m_endlessWidth = width; });
    }
    std::vector<RayCastSettings> startedSettings() {
        const std::lock_guard lock(m_mutex);
        return m_started;
    }
    int started() { return static_cast<int>(startedSettings().size()); }
    int lettingGo() {
        const std::lock_guard lock(m_mutex);
        return m_lettingGo;
    }

private:
    template <typename Change>
    void set(const Change& change) {
        const std::lock_guard lock(m_mutex);
        change();
        m_changed.notify_all();
    }
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_held = false;
    int m_endlessWidth = 0, m_lettingGo = 0;
    std::vector<RayCastSettings> m_started;
};

struct Setup {
    Setup() {
        QObject::connect(&caster, &ProgressiveCaster::delivered,
                         [this](const std::shared_ptr<const CastPicture>& picture) { delivered.push_back(picture); });
    }
    PictureRequest request(double level, int width = 120) const {
        PictureRequest made{{{volume, ManualCurve{{{0.0, level}}}}}, {}};
        made.settings.width = width;
        made.settings.height = 90;
        return made;
    }
    /// A request with another camera for each level.
    PictureRequest turned(double level) const {
        PictureRequest made = request(level);
        made.settings.camera.frame = frameOf({BeamAxis::plusZ, 90 * level, 0, 0});
        return made;
    }
    CommandedCaster commands, cardCommands;
    std::shared_ptr<const Volume> volume = volumeOf(geometryOf(2, 2, 2), [](double, double, double) { return 9; });
    std::vector<std::shared_ptr<const CastPicture>> delivered;
    Works works;
    ProgressiveCaster caster{
        works, PreviewQuality{0.0},  // no budget: a preview always comes first
        [this](const PictureRequest& request, const Progress& progress) { return commands(request, progress); },
        [this](const PictureRequest& request, const Progress& progress) { return cardCommands(request, progress); }};
};

}  // namespace echolucent
